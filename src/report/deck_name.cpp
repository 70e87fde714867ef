// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/deck_name.hpp"

#include "base/printable.hpp"

#include <filesystem>

namespace spricka::report {

std::string relative_deck_file_name(const base::SourceTexts& sources, std::int32_t file) {
  if (file < 0 || static_cast<std::size_t>(file) >= sources.count()) {
    return {};
  }
  const std::string& name = sources.file_name(file);
  if (name.starts_with("-D ") || name.starts_with('<')) { // no file
    return base::make_printable(name);
  }
  namespace fs = std::filesystem;
  const fs::path path = fs::path(name).lexically_normal();
  const fs::path folder = fs::path(sources.file_name(0)).lexically_normal().parent_path();
  const fs::path seen = path.lexically_relative(folder.empty() ? "." : folder);
  return base::make_printable(seen.empty() ? path.filename().string() : seen.string());
}

} // namespace spricka::report
