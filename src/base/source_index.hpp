// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/source.hpp"

#include <cstddef>
#include <cstdint>
#include <map>
#include <string_view>
#include <vector>

namespace spricka::base {

/// Places of many offsets: SourceTexts::locate counts from the beginning of the text each time,
/// this from the block that the offset is in. Texts that are added later are seen too.
class SourceIndex {
public:
  explicit SourceIndex(const SourceTexts& sources) : sources_(sources) {}

  /// The same as SourceTexts::locate.
  SourceLocation locate(std::int32_t file, std::size_t offset);

private:
  struct LineCountBlock {
    std::size_t lines = 0;      ///< line feeds before it
    std::size_t characters = 0; ///< of its line before it
  };
  const std::vector<LineCountBlock>& blocks_of(std::int32_t file);

  const SourceTexts& sources_;
  std::map<std::int32_t, std::vector<LineCountBlock>> blocks_;
};

} // namespace spricka::base
