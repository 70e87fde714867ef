// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/deflater.hpp"

#include <zlib.h>

#include <cerrno>
#include <system_error>

namespace spricka::base {
namespace {

void demand_success(bool done) {
  if (!done) {
    throw std::system_error(ENOMEM, std::generic_category(), "zlib");
  }
}

} // namespace

Deflater::Deflater(RepetitionSearch search, std::size_t longest)
    : stream_(std::make_unique<z_stream>()) {
  constexpr int window_bits = 15;
  constexpr int memory_level = 8; // what zlib takes where nothing is said
  demand_success(
      deflateInit2(stream_.get(),
                   search == RepetitionSearch::thorough ? Z_DEFAULT_COMPRESSION : Z_BEST_SPEED,
                   Z_DEFLATED, window_bits, memory_level,
                   search == RepetitionSearch::runs ? Z_RLE : Z_DEFAULT_STRATEGY) == Z_OK);
  buffer_.resize(deflateBound(stream_.get(), static_cast<uLong>(longest)));
}

Deflater::~Deflater() {
  deflateEnd(stream_.get());
}

std::string_view Deflater::pack(std::string_view block) {
  demand_success(deflateReset(stream_.get()) == Z_OK);
  // zlib does not change what it reads
  stream_->next_in = reinterpret_cast<Bytef*>(const_cast<char*>(block.data())); // NOLINT
  stream_->avail_in = static_cast<uInt>(block.size());
  stream_->next_out = reinterpret_cast<Bytef*>(buffer_.data());
  stream_->avail_out = static_cast<uInt>(buffer_.size());
  demand_success(deflate(stream_.get(), Z_FINISH) == Z_STREAM_END);
  return std::string_view(buffer_).substr(0, buffer_.size() - stream_->avail_out);
}

} // namespace spricka::base
