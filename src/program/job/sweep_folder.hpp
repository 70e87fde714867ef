// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "archive/folder_lock.hpp"

#include <filesystem>
#include <optional>
#include <set>
#include <string>

namespace spricka::program {

/// The folder of many runs: the points of a sweep, or what the tasks of a job array have run of a
/// study or verification. It is locked from open() on, by one process alone or by many that share
/// it, and knows which tables in it are ours.
class SweepFolder {
public:
  explicit SweepFolder(std::filesystem::path path) : path_(std::move(path)) {}
  ~SweepFolder() { close(); }
  SweepFolder(const SweepFolder&) = delete;
  SweepFolder& operator=(const SweepFolder&) = delete;

  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

  /// A folder of a sweep is gone on with, any other refused but for an empty one. Throws
  /// std::system_error or FileFailure (E464, E465) when it cannot be used.
  void open(archive::LockSharing sharing);

  /// Removes folders of points that the sweep does not have, by their names: digits, and
  /// digits.failed.
  void remove_others(const std::set<std::string>& wanted) const;

  /// The place of a table of ours, new or to be replaced. Throws FileFailure E464 where somebody
  /// else's file has that name.
  [[nodiscard]] std::filesystem::path table_file(const std::string& name) const;

  /// Nobody works in it any more.
  void close() const;

private:
  void make_with_mark() const;

  std::filesystem::path path_;
  bool names_owner_ = false; ///< a note in it says who writes it
  std::optional<archive::FolderLock> lock_;
};

} // namespace spricka::program
