// SPDX-License-Identifier: GPL-3.0-or-later
#include "archive/folder_lock.hpp"

#include "archive/folder_mark.hpp"
#include "archive/safe_file.hpp"
#include "base/input_file.hpp"
#include "base/output_file.hpp"

#include <array>
#include <cerrno>
#include <charconv>
#include <csignal>
#include <string>
#include <system_error>

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

namespace spricka::archive {

namespace {

namespace fs = std::filesystem;

std::string host_name() {
  std::array<char, 256> name{};
  return ::gethostname(name.data(), name.size() - 1) == 0 ? name.data() : "?";
}

struct Owner {
  pid_t process = 0;
  std::string host;
};

// "process 1234 on node7"
std::optional<Owner> owner_of(const fs::path& folder) {
  try {
    const std::string text = base::read_file_beginning(folder / owner_name, 1024);
    const std::string_view before = "process ";
    const std::size_t on = text.find(" on ");
    const std::size_t end = text.find('\n');
    if (!text.starts_with(before) || on == std::string::npos || end == std::string::npos) {
      return std::nullopt;
    }
    Owner owner;
    std::from_chars(text.data() + before.size(), text.data() + on, owner.process);
    owner.host = text.substr(on + 4, end - on - 4);
    return owner;
  } catch (const base::UnreadableFile&) {
    return std::nullopt;
  }
}

[[noreturn]] void taken(const fs::path& folder, const std::optional<Owner>& owner) {
  const std::string who =
      owner ? fmt::format(" (process {} on {})", owner->process, owner->host) : "";
  throw FileFailure("E465",
                    fmt::format("{}: another run{} is writing it; wait for it, or name another "
                                "folder with --out",
                                folder.string(), who));
}

} // namespace

std::optional<FolderLock> FolderLock::acquire_lock(const fs::path& folder, const fs::path& work,
                                                   LockSharing sharing) {
  FolderLock lock(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  if (lock.fd_ < 0) {
    if (errno == ENOENT) {
      return std::nullopt;
    }
    throw std::system_error(errno, std::generic_category(), folder.string());
  }
  // Where locks do not work the owner's note decides: a process that lives, or one on another
  // machine.
  const int kind = sharing == LockSharing::shared ? LOCK_SH : LOCK_EX;
  if (::flock(lock.fd_, kind | LOCK_NB) != 0) {
    const int error = errno;
    std::optional<Owner> owner = owner_of(folder);
    owner = owner ? owner : owner_of(work);
    const bool here = owner && owner->host == host_name();
    const bool lives = owner && owner->process != ::getpid() &&
                       (!here || ::kill(owner->process, 0) == 0 || errno == EPERM);
    if (error == EWOULDBLOCK || lives) {
      taken(folder, owner);
    }
  }
  // The folder may have been moved or removed between opening and locking: then it is tried again.
  struct stat opened {};
  struct stat named {};
  const bool same = ::fstat(lock.fd_, &opened) == 0 && ::stat(folder.c_str(), &named) == 0 &&
                    opened.st_dev == named.st_dev && opened.st_ino == named.st_ino;
  return same ? std::optional(std::move(lock)) : std::nullopt;
}

FolderLock::~FolderLock() {
  if (fd_ >= 0) {
    ::close(fd_);
  }
}

void write_lock_owner(const fs::path& folder) {
  base::write_atomically(folder / owner_name,
                         fmt::format("process {} on {}\n", ::getpid(), host_name()));
}

} // namespace spricka::archive
