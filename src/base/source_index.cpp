// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/source_index.hpp"

#include <algorithm>

namespace spricka::base {

namespace {

constexpr std::size_t block_size = 1024; ///< [bytes]

} // namespace

const std::vector<SourceIndex::LineCountBlock>& SourceIndex::blocks_of(std::int32_t file) {
  std::vector<LineCountBlock>& blocks = blocks_[file];
  if (!blocks.empty()) {
    return blocks;
  }
  const std::string_view text = sources_.text(file);
  blocks.reserve(text.size() / block_size + 1);
  LineCountBlock now;
  for (std::size_t at = 0; at <= text.size(); ++at) {
    if (at % block_size == 0) {
      blocks.push_back(now);
    }
    if (at < text.size() && text[at] == '\n') {
      ++now.lines;
      now.characters = 0;
    } else if (at < text.size() && is_utf8_character_start(text[at])) {
      ++now.characters;
    }
  }
  return blocks;
}

SourceLocation SourceIndex::locate(std::int32_t file, std::size_t offset) {
  const std::string_view text = sources_.text(file);
  offset = std::min(offset, text.size());
  const std::size_t block = offset / block_size;
  LineCountBlock now = blocks_of(file)[block];
  for (std::size_t at = block * block_size; at < offset; ++at) {
    if (text[at] == '\n') {
      ++now.lines;
      now.characters = 0;
    } else if (is_utf8_character_start(text[at])) {
      ++now.characters;
    }
  }
  return {now.lines + 1, now.characters + 1};
}

} // namespace spricka::base
