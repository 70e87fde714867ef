// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/import/nested_text_files.hpp"

#include "base/input_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <system_error>
#include <utility>

namespace spricka::mesh {
namespace {

constexpr std::size_t deepest_nesting = 16;
constexpr std::size_t most_nested_files = 1000; ///< each as often as it is included

} // namespace

NestedTextFiles::NestedTextFiles(const std::filesystem::path& file, std::string statement,
                                 Complain complain)
    : statement_(std::move(statement)), complain_(std::move(complain)) {
  open(file, {});
}

void NestedTextFiles::open(const std::filesystem::path& path, InpLocation from) {
  const auto same = [&](std::uint32_t f) { return files_[f].path == path; };
  if (std::any_of(open_.begin(), open_.end(), same)) {
    complain_(from, fmt::format("{}: '{}' includes itself", statement_, path.string()));
    return;
  }
  if (open_.size() >= deepest_nesting) {
    complain_(from, fmt::format("{}: files are nested too deep", statement_));
    return;
  }
  if (files_.size() > most_nested_files) {
    if (files_.size() == most_nested_files + 1) { // once: those that follow are as many again
      complain_(from,
                fmt::format("{}: more than {} files are included", statement_, most_nested_files));
      files_.emplace_back();
    }
    return;
  }
  TextFile file;
  file.path = path;
  std::error_code unknown;
  if (!std::filesystem::exists(path, unknown)) {
    complain_(from, fmt::format("there is no file '{}'", path.string()));
    return;
  }
  try {
    file.text = base::read_file(path, base::largest_mesh_file - bytes_);
  } catch (const base::UnreadableFile& trouble) {
    complain_(from, trouble.what());
    return;
  }
  bytes_ += file.text.size();
  open_.push_back(static_cast<std::uint32_t>(files_.size()));
  files_.push_back(std::move(file));
}

bool NestedTextFiles::next_line() {
  while (!open_.empty()) {
    TextFile& file = files_[open_.back()];
    if (file.at < file.text.size()) {
      const std::size_t end = std::min(file.text.find('\n', file.at), file.text.size());
      line_ = std::string_view(file.text).substr(file.at, end - file.at);
      if (line_.ends_with('\r')) {
        line_.remove_suffix(1);
      }
      file.at = end + 1;
      place_ = {open_.back(), ++file.line};
      return true;
    }
    file.text = std::string(); // big files are not kept
    open_.pop_back();
  }
  return false;
}

void NestedTextFiles::include(const std::string& path, InpLocation from) {
  open(files_[from.file].path.parent_path() / path, from);
}

std::vector<std::string> NestedTextFiles::file_paths() const {
  std::vector<std::string> paths;
  for (const TextFile& file : files_) {
    paths.push_back(file.path.string());
  }
  return paths;
}

} // namespace spricka::mesh
