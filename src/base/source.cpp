// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/source.hpp"

#include <algorithm>
#include <utility>

namespace spricka::base {

namespace {

std::size_t line_start(std::string_view text, std::size_t offset) {
  const std::size_t before = offset == 0 ? std::string_view::npos : text.rfind('\n', offset - 1);
  return before == std::string_view::npos ? 0 : before + 1;
}

} // namespace

std::int32_t SourceTexts::add_text(std::string name, std::string text) {
  files_.push_back({std::move(name), std::move(text)});
  return static_cast<std::int32_t>(files_.size() - 1);
}

const std::string& SourceTexts::file_name(std::int32_t file) const {
  return files_[static_cast<std::size_t>(file)].name;
}

std::string_view SourceTexts::text(std::int32_t file) const {
  return files_[static_cast<std::size_t>(file)].text;
}

std::string_view SourceTexts::text(SourceSpan span) const {
  return text(span.file).substr(span.begin, span.end - span.begin);
}

SourceLocation SourceTexts::locate(std::int32_t file, std::size_t offset) const {
  const std::string_view all = text(file);
  offset = std::min(offset, all.size());
  const std::size_t begin = line_start(all, offset);
  const auto lines =
      std::count(all.begin(), all.begin() + static_cast<std::ptrdiff_t>(begin), '\n');
  const auto columns =
      std::count_if(all.begin() + static_cast<std::ptrdiff_t>(begin),
                    all.begin() + static_cast<std::ptrdiff_t>(offset), is_utf8_character_start);
  return {static_cast<std::size_t>(lines) + 1, static_cast<std::size_t>(columns) + 1};
}

std::string_view SourceTexts::line_at(std::int32_t file, std::size_t offset) const {
  const std::string_view all = text(file);
  const std::size_t begin = line_start(all, std::min(offset, all.size()));
  std::string_view line = all.substr(begin, all.find('\n', begin) - begin);
  if (line.ends_with('\r')) {
    line.remove_suffix(1);
  }
  return line;
}

} // namespace spricka::base
