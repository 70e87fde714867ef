// SPDX-License-Identifier: GPL-3.0-or-later
#include "solve/scratch_folder.hpp"

#include <cstdlib>
#include <filesystem>
#include <mutex>
#include <string_view>
#include <system_error>
#include <utility>

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

namespace spricka::solve {

namespace {

namespace fs = std::filesystem;

constexpr std::string_view folder_prefix = "spricka-scratch-";
constexpr const char* lock_name = "in_use";

/// The lock of a folder that is in use, held as long as its process lives, however that ends; -1:
/// another has it, or it cannot be had.
int take_lock(const fs::path& folder) {
  const int file = open((folder / lock_name).c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0600);
  if (file >= 0 && flock(file, LOCK_EX | LOCK_NB) != 0) {
    close(file);
    return -1;
  }
  return file;
}

// Nobody cleans up behind a process that was killed but the next one.
void remove_left_folders(const fs::path& temporary) {
  std::error_code unknown;
  for (fs::directory_iterator at(temporary, unknown); !unknown && at != fs::directory_iterator();
       at.increment(unknown)) {
    std::error_code trouble;
    if (!at->path().filename().string().starts_with(folder_prefix) ||
        !fs::exists(at->path() / lock_name, trouble)) {
      continue; // without a lock it is just being made
    }
    if (const int lock = take_lock(at->path()); lock >= 0) {
      fs::remove_all(at->path(), trouble);
      close(lock);
    }
  }
}

class ProcessScratchFolder {
public:
  ~ProcessScratchFolder() { remove(); }
  ProcessScratchFolder() = default;
  ProcessScratchFolder(const ProcessScratchFolder&) = delete;
  ProcessScratchFolder& operator=(const ProcessScratchFolder&) = delete;

  std::string path() {
    const std::scoped_lock guard(mutex_);
    if (path_.empty()) {
      make();
    }
    return path_;
  }
  void remove() {
    const std::scoped_lock guard(mutex_);
    if (!path_.empty()) {
      std::error_code trouble;
      fs::remove_all(path_, trouble);
      close(lock_);
      path_.clear();
    }
  }

private:
  void make() {
    std::error_code unknown;
    const fs::path temporary = fs::temp_directory_path(unknown);
    if (unknown) {
      return;
    }
    remove_left_folders(temporary);
    std::string name = (temporary / (std::string(folder_prefix) + "XXXXXX")).string();
    if (mkdtemp(name.data()) == nullptr) {
      return;
    }
    lock_ = take_lock(name);
    path_ = std::move(name);
  }

  std::mutex mutex_;
  std::string path_;
  int lock_ = -1;
};

ProcessScratchFolder& process_scratch_folder() {
  static ProcessScratchFolder folder;
  return folder;
}

} // namespace

std::string scratch_folder() {
  return process_scratch_folder().path();
}

void remove_scratch_folder() {
  process_scratch_folder().remove();
}

} // namespace spricka::solve
