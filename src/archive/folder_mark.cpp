// SPDX-License-Identifier: GPL-3.0-or-later
#include "archive/folder_mark.hpp"

#include "base/input_file.hpp"
#include "base/output_file.hpp"

#include <algorithm>
#include <cerrno>
#include <system_error>

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

namespace spricka::archive {

namespace {

namespace fs = std::filesystem;

constexpr std::size_t largest_mark = 16 * base::mebibyte;

std::string first_line(RunOrSweepFolder kind) {
  return fmt::format("spricka {} folder, format 1: what follows are the files that it wrote here",
                     kind == RunOrSweepFolder::run ? "run" : "sweep");
}

// Nothing but a file of the folder itself: a mark that was made by hand reaches no other.
bool is_plain(std::string_view name) {
  return !name.empty() && name != "." && name != ".." && name != mark_name && name != owner_name &&
         name.find('/') == std::string_view::npos && name.find('\0') == std::string_view::npos;
}

// The file that a name like "k.csv.1234.part" or "k.csv.1234.1.part" was to become
// (base/output_file.hpp); empty for other names.
std::string finished_name(std::string_view name) {
  constexpr std::string_view part = ".part";
  if (!name.ends_with(part)) {
    return {};
  }
  name.remove_suffix(part.size());
  for (int numbers = 0; numbers < 2; ++numbers) {
    const std::size_t dot = name.rfind('.');
    const std::size_t last = name.find_last_not_of("0123456789");
    if (dot == std::string_view::npos || dot != last || dot + 1 == name.size()) {
      return numbers == 0 ? std::string() : std::string(name);
    }
    name = name.substr(0, dot);
  }
  return std::string(name);
}

bool knows(const FolderManifest& mark, const std::string& name) {
  return name == mark_name || name == owner_name ||
         std::ranges::find(mark.files, name) != mark.files.end();
}

bool is_folder(const fs::path& file) {
  std::error_code unknown;
  return fs::is_directory(fs::symlink_status(file, unknown));
}

void remove_file(const fs::path& file) {
  if (!is_folder(file)) {
    ::unlink(file.c_str());
  }
}

} // namespace

std::optional<FolderManifest> read_folder_manifest(const fs::path& folder) {
  const fs::path file = folder / mark_name;
  std::error_code unknown;
  if (!fs::is_regular_file(fs::symlink_status(file, unknown))) {
    return std::nullopt;
  }
  std::string text;
  try {
    text = base::read_file(file, largest_mark);
  } catch (const base::UnreadableFile&) {
    return std::nullopt;
  }
  std::optional<FolderManifest> mark;
  std::string_view rest = text;
  while (!rest.empty()) {
    const std::size_t end = rest.find('\n');
    if (end == std::string_view::npos) {
      break; // the program ended while it wrote this line: there is no such file
    }
    const std::string_view line = rest.substr(0, end);
    rest.remove_prefix(end + 1);
    if (mark) {
      if (is_plain(line) && std::ranges::find(mark->files, line) == mark->files.end()) {
        mark->files.emplace_back(line);
      }
      continue;
    }
    for (const RunOrSweepFolder kind : {RunOrSweepFolder::run, RunOrSweepFolder::sweep}) {
      if (line == first_line(kind)) {
        mark = FolderManifest{kind, {}};
      }
    }
    if (!mark) {
      return std::nullopt;
    }
  }
  return mark;
}

void write_folder_manifest(const fs::path& folder, const FolderManifest& mark) {
  std::string text = first_line(mark.kind) + "\n";
  for (const std::string& name : mark.files) {
    text += name + "\n";
  }
  base::write_atomically(folder / mark_name, text);
}

void add_to_folder_manifest(const fs::path& folder, const std::string& name) {
  const fs::path file = folder / mark_name;
  const std::string line = name + "\n";
  // Appended in one write: a line is there as a whole, or cut off and not read.
  const int fd = ::open(file.c_str(), O_WRONLY | O_APPEND | O_CLOEXEC | O_NOFOLLOW);
  const bool written =
      fd >= 0 && ::write(fd, line.data(), line.size()) == static_cast<ssize_t>(line.size());
  const int error = errno;
  if (fd >= 0) {
    ::close(fd);
  }
  if (!written) {
    throw std::system_error(error == 0 ? ENOSPC : error, std::generic_category(),
                            "cannot write " + file.string());
  }
}

std::vector<std::string> find_foreign_files(const fs::path& folder, const FolderManifest& mark) {
  std::vector<std::string> names;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
    const std::string name = entry.path().filename().string();
    const std::string finished = finished_name(name);
    const bool known = knows(mark, name) || (!finished.empty() && knows(mark, finished));
    if (!known || is_folder(entry.path())) {
      names.push_back(name);
    }
  }
  std::ranges::sort(names);
  return names;
}

void remove_manifest_files(const fs::path& folder) {
  const std::optional<FolderManifest> mark = read_folder_manifest(folder);
  if (!mark) {
    return;
  }
  std::error_code unknown;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, unknown)) {
    const std::string finished = finished_name(entry.path().filename().string());
    if (!finished.empty() && knows(*mark, finished)) {
      remove_file(entry.path());
    }
  }
  for (const std::string& name : mark->files) {
    remove_file(folder / name);
  }
  // The mark goes last, and stays with what is not ours: no file of ours is taken for a foreign one
  // if the program ends here.
  remove_file(folder / owner_name);
  if (find_foreign_files(folder, *mark).empty()) {
    remove_file(folder / mark_name);
    fs::remove(folder, unknown);
  }
}

} // namespace spricka::archive
