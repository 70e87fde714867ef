// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <filesystem>
#include <optional>
#include <utility>

namespace spricka::archive {

/// Who else may hold a lock: nobody, or others that hold it as shared.
enum class LockSharing { exclusive, shared };

/// A folder that no second run may write: locked while the object lives and the program runs,
/// whatever ends it (flock). Where the file system has no such locks, the file .spricka.owner
/// counts, by its process and host.
class FolderLock {
public:
  /// Locks a folder that is there; empty if it has gone meanwhile. Throws FileFailure E465 when
  /// another run has it, with the process and host that are named in it or in the folder `work`.
  static std::optional<FolderLock> acquire_lock(const std::filesystem::path& folder,
                                                const std::filesystem::path& work,
                                                LockSharing sharing = LockSharing::exclusive);
  FolderLock(FolderLock&& other) noexcept : fd_(std::exchange(other.fd_, -1)) {}
  FolderLock& operator=(FolderLock&& other) noexcept {
    std::swap(fd_, other.fd_);
    return *this;
  }
  ~FolderLock();

private:
  explicit FolderLock(int fd) : fd_(fd) {}
  int fd_;
};

/// Writes who we are into a folder that is locked. Throws std::system_error.
void write_lock_owner(const std::filesystem::path& folder);

} // namespace spricka::archive
