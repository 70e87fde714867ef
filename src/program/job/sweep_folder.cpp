// SPDX-License-Identifier: GPL-3.0-or-later
#include "program/job/sweep_folder.hpp"

#include "archive/folder_mark.hpp"
#include "archive/safe_file.hpp"
#include "program/job/point_record.hpp"
#include "program/job/run_folder.hpp"

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <string_view>
#include <system_error>
#include <vector>

#include <fmt/format.h>
#include <stdlib.h> // NOLINT(modernize-deprecated-headers): mkdtemp is of POSIX

namespace spricka::program {

namespace {

namespace fs = std::filesystem;

// "007" or "007.failed"
bool is_folder_of_point(std::string name) {
  if (name.ends_with(failed_point_ending)) {
    name.resize(name.size() - std::string_view(failed_point_ending).size());
  }
  return !name.empty() && name.find_first_not_of("0123456789") == std::string::npos;
}

} // namespace

// It has its mark from the first moment on, as all tasks of an array begin at the same time: none
// finds the folder of another without.
void SweepFolder::make_with_mark() const {
  const archive::FolderManifest mark{archive::RunOrSweepFolder::sweep, {}};
  fs::create_directories(path_.parent_path());
  std::string aside = path_.string() + ".XXXXXX";
  if (::mkdtemp(aside.data()) == nullptr) {
    throw std::system_error(errno, std::generic_category(), aside);
  }
  const fs::path made = fs::path(aside) / path_.filename();
  fs::create_directory(made); // with the rights that new folders have
  archive::write_folder_manifest(made, mark);
  std::error_code unknown;
  if (fs::is_directory(path_, unknown)) {
    fs::permissions(made, fs::status(path_).permissions(), unknown);
  }
  const int error = std::rename(made.c_str(), path_.c_str()) == 0 ? 0 : errno;
  if (error != 0) {
    archive::remove_manifest_files(made);
  }
  fs::remove(aside, unknown);
  if (error != 0 && error != EEXIST && error != ENOTEMPTY) { // a mount point
    archive::write_folder_manifest(path_, mark);
  }
}

void SweepFolder::open(archive::LockSharing sharing) {
  check_folder_ownership(path_, true);
  if (!archive::read_folder_manifest(path_)) {
    make_with_mark();
  }
  lock_ = archive::FolderLock::acquire_lock(path_, path_, sharing);
  check_folder_ownership(path_, true); // another run may have ended meanwhile
  if (!lock_) {
    throw std::system_error(std::make_error_code(std::errc::no_such_file_or_directory),
                            path_.string());
  }
  if (sharing == archive::LockSharing::exclusive) {
    archive::write_lock_owner(path_);
    names_owner_ = true;
  }
}

void SweepFolder::remove_others(const std::set<std::string>& wanted) const {
  std::vector<fs::path> others;
  for (const fs::directory_entry& entry : fs::directory_iterator(path_)) {
    const std::string name = entry.path().filename().string();
    if (is_folder_of_point(name) && !wanted.contains(name)) {
      others.push_back(entry.path());
    }
  }
  std::ranges::for_each(others, archive::remove_manifest_files);
}

void SweepFolder::close() const {
  std::error_code ignored;
  if (names_owner_) {
    fs::remove(path_ / archive::owner_name, ignored);
  }
}

fs::path SweepFolder::table_file(const std::string& name) const {
  const archive::FolderManifest mark =
      archive::read_folder_manifest(path_).value_or(archive::FolderManifest{});
  if (std::ranges::find(mark.files, name) == mark.files.end()) {
    if (fs::exists(fs::symlink_status(path_ / name))) {
      throw archive::FileFailure("E464",
                                 fmt::format("{} is there, and no sweep wrote it; name another "
                                             "folder with --out",
                                             (path_ / name).string()));
    }
    archive::add_to_folder_manifest(path_, name);
  }
  return path_ / name;
}

} // namespace spricka::program
