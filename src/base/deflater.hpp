// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <cstddef>
#include <memory>
#include <string>
#include <string_view>

struct z_stream_s; // of zlib

namespace spricka::base {

/// What zlib looks for in what it packs, besides letters that are more frequent than others.
enum class RepetitionSearch {
  thorough, ///< what comes again, with zlib's usual effort
  quick,    ///< what comes again, with the least effort
  /// runs of one byte: in measured numbers nothing else comes again, and looking for more takes
  /// several times as long for a twentieth of the size
  runs,
};

/// Packs bytes in the format of zlib (RFC 1950), blocks one after the other, each by itself.
class Deflater {
public:
  /// Blocks of up to `longest` bytes. Throws std::system_error without memory, as pack().
  Deflater(RepetitionSearch search, std::size_t longest);
  ~Deflater();
  Deflater(const Deflater&) = delete;
  Deflater& operator=(const Deflater&) = delete;

  /// The block packed; valid until the next.
  std::string_view pack(std::string_view block);

private:
  std::unique_ptr<z_stream_s> stream_;
  std::string buffer_;
};

} // namespace spricka::base
