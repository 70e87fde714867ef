// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/output_file.hpp"

#include <cerrno>
#include <string>
#include <system_error>
#include <utility>

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

namespace spricka::base {

namespace {

namespace fs = std::filesystem;

constexpr mode_t all_may = 0666; // less what the umask takes

fs::path folder_of(const fs::path& file) {
  const fs::path folder = file.parent_path();
  return folder.empty() ? fs::path(".") : folder;
}

/// The file while it is written. Without a name where the file system can: nothing is left of it
/// when the program is killed.
class Unfinished {
public:
  explicit Unfinished(const fs::path& file) : file_(file) {
    fd_ = ::open(folder_of(file).c_str(), O_TMPFILE | O_WRONLY | O_CLOEXEC, all_may);
    for (int attempt = 0; fd_ < 0 && attempt < 100; ++attempt) {
      part_ = unused_temporary_path(file);
      fd_ = ::open(part_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, all_may);
      if (fd_ < 0 && errno != EEXIST) {
        break;
      }
    }
    if (fd_ < 0) {
      part_.clear();
      fail();
    }
  }
  ~Unfinished() {
    if (fd_ >= 0) {
      ::close(fd_);
    }
    if (!part_.empty()) {
      ::unlink(part_.c_str());
    }
  }
  Unfinished(const Unfinished&) = delete;
  Unfinished& operator=(const Unfinished&) = delete;

  void write(std::string_view bytes) const {
    while (!bytes.empty()) {
      const ssize_t n = ::write(fd_, bytes.data(), bytes.size());
      if (n < 0 && errno != EINTR) {
        fail();
      }
      bytes.remove_prefix(n > 0 ? static_cast<std::size_t>(n) : 0);
    }
  }
  void sync() const {
    if (::fsync(fd_) != 0) {
      fail();
    }
  }
  void give_name() {
    if (part_.empty()) {
      link();
    }
    if (::close(std::exchange(fd_, -1)) != 0) { // a full disk may show only here
      fail();
    }
    if (!part_.empty() && ::rename(part_.c_str(), file_.c_str()) != 0) {
      fail();
    }
    part_.clear();
  }

private:
  [[noreturn]] void fail() const {
    throw std::system_error(errno, std::generic_category(), "cannot write " + file_.string());
  }
  void link() {
    const std::string self = fmt::format("/proc/self/fd/{}", fd_);
    const auto as = [&](const fs::path& name) {
      return ::linkat(AT_FDCWD, self.c_str(), AT_FDCWD, name.c_str(), AT_SYMLINK_FOLLOW) == 0;
    };
    if (as(file_)) {
      return;
    }
    if (errno != EEXIST) {
      fail();
    }
    for (int attempt = 0; attempt < 100; ++attempt) {
      const fs::path part = unused_temporary_path(file_);
      if (as(part)) {
        part_ = part;
        return;
      }
      if (errno != EEXIST) {
        fail();
      }
    }
    fail();
  }

  fs::path file_;
  fs::path part_; ///< its name so far; empty: none
  int fd_ = -1;
};

} // namespace

fs::path unused_temporary_path(const fs::path& file) {
  fs::path part;
  std::error_code unknown;
  for (int number = 0; number == 0 || fs::exists(fs::symlink_status(part, unknown)); ++number) {
    part = file;
    part += number == 0 ? fmt::format(".{}.part", ::getpid())
                        : fmt::format(".{}.{}.part", ::getpid(), number);
  }
  return part;
}

void write_atomically(const fs::path& file, std::string_view bytes, DiskSync sync) {
  Unfinished out(file);
  out.write(bytes);
  if (sync == DiskSync::yes) {
    out.sync();
  }
  out.give_name();
  if (sync == DiskSync::yes) {
    // A folder that cannot be synced (some network file systems) is none of ours to mend.
    const int folder = ::open(folder_of(file).c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (folder >= 0) {
      ::fsync(folder);
      ::close(folder);
    }
  }
}

} // namespace spricka::base
