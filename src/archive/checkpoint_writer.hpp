// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "archive/checkpoint_list.hpp"

#include <cstddef>
#include <filesystem>
#include <functional>
#include <mutex>
#include <string>
#include <vector>

/// The files of a restart file: its list, the list before and the folder of increments.
namespace spricka::archive {

/// The folder with the increments of a restart file.
std::filesystem::path increments_folder(const std::filesystem::path& file);
/// The list before the last of a restart file.
std::filesystem::path previous_list_file(const std::filesystem::path& file);
/// The list in a file. Throws FileFailure where it cannot be read or is no list.
CheckpointList read_checkpoint_list_file(const std::filesystem::path& file);

/// Writes a restart file: each increment in a file of its own, then the list that names all of
/// them. The folder is locked against a second run.
class CheckpointWriter {
public:
  /// The bytes of a list of these entries.
  using ListBytes = std::function<std::string(const std::vector<CheckpointEntry>&)>;

  /// Opens the place. Throws FileFailure for one that cannot be used.
  CheckpointWriter(std::filesystem::path file, ListBytes list_bytes);
  ~CheckpointWriter();
  CheckpointWriter(const CheckpointWriter&) = delete;
  CheckpointWriter& operator=(const CheckpointWriter&) = delete;

  /// Lists an increment whose file is in the folder already.
  void add_existing_entry(const CheckpointEntry& entry);
  /// Lists an increment of these bytes, by whose hash its file is named; it is not on disk yet.
  void add_increment(CheckpointEntry entry, const std::string& bytes);
  /// Puts on disk what is not there yet; from any thread. The number of increments that are listed
  /// there. Throws FileFailure E563.
  std::size_t flush();

private:
  struct PendingFile {
    std::string file, bytes;
  };

  void open_to_write();
  void put_on_disk();
  void sweep_folder() const;

  std::filesystem::path file_;
  ListBytes list_bytes_;
  std::mutex guard_;                     ///< of all below
  std::vector<CheckpointEntry> entries_; ///< to be listed
  std::vector<PendingFile> pending_;     ///< listed, not yet on disk
  std::string pending_list_;             ///< that lists them: HDF5 is used by one thread only
  std::size_t on_disk_ = 0;              ///< entries in the list on disk
  std::vector<std::string> before_;      ///< files of the list before
  int lock_ = -1;                        ///< folder, locked against a second run
};

} // namespace spricka::archive
