// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/input_file.hpp"

#include <algorithm>
#include <cerrno>
#include <cstring>

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

namespace spricka::base {

namespace {

namespace fs = std::filesystem;

[[noreturn]] void refuse(const fs::path& file, int error) {
  throw UnreadableFile({error, std::generic_category()},
                       fmt::format("cannot read '{}': {}", file.string(), std::strerror(error)));
}

[[noreturn]] void too_large(const fs::path& file, std::size_t limit) {
  throw UnreadableFile(
      std::make_error_code(std::errc::file_too_large),
      fmt::format("'{}' is too large: at most {} MiB are read", file.string(), limit / mebibyte));
}

void check_kind(const fs::path& file, const struct stat& of) {
  const char* kind = S_ISREG(of.st_mode)                          ? nullptr
                     : S_ISDIR(of.st_mode)                        ? "a folder"
                     : S_ISFIFO(of.st_mode)                       ? "a pipe"
                     : S_ISSOCK(of.st_mode)                       ? "a socket"
                     : S_ISCHR(of.st_mode) || S_ISBLK(of.st_mode) ? "a device"
                                                                  : "something else";
  if (kind != nullptr) {
    throw UnreadableFile(std::make_error_code(S_ISDIR(of.st_mode) ? std::errc::is_a_directory
                                                                  : std::errc::invalid_argument),
                         fmt::format("'{}' is {}, not a file", file.string(), kind));
  }
}

class Open {
public:
  // Looked at by its name first: to open a device may do something.
  explicit Open(const fs::path& file) : file_(file) {
    struct stat of {};
    if (::stat(file.c_str(), &of) != 0) {
      refuse(file, errno);
    }
    check_kind(file, of);
    fd_ = ::open(file.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK | O_NOCTTY);
    if (fd_ < 0 || ::fstat(fd_, &of) != 0) {
      refuse(file, errno);
    }
    check_kind(file, of);
    size_ = static_cast<std::size_t>(of.st_size);
  }
  ~Open() { ::close(fd_); }
  Open(const Open&) = delete;
  Open& operator=(const Open&) = delete;
  [[nodiscard]] std::size_t size() const { return size_; }
  // 0 at the end.
  std::size_t read(char* to, std::size_t most) const {
    for (;;) {
      const ssize_t got = ::read(fd_, to, most);
      if (got >= 0) {
        return static_cast<std::size_t>(got);
      }
      if (errno != EINTR) {
        refuse(file_, errno);
      }
    }
  }

private:
  const fs::path& file_;
  std::size_t size_ = 0;
  int fd_ = -1;
};

} // namespace

std::string read_file(const fs::path& file, std::size_t limit) {
  const Open open(file);
  if (open.size() > limit) {
    too_large(file, limit);
  }
  // One byte more shows the end; what has no size of its own (/proc) or grows, by larger steps.
  constexpr std::size_t chunk = std::size_t{1} << 16U;
  std::string text(open.size() + 1, '\0');
  std::size_t filled = 0;
  while (const std::size_t got = open.read(text.data() + filled, text.size() - filled)) {
    filled += got;
    if (filled > limit) {
      too_large(file, limit);
    }
    if (filled == text.size()) {
      text.resize(filled + std::max(chunk, filled / 2));
    }
  }
  text.resize(filled);
  return text;
}

std::string read_file_beginning(const fs::path& file, std::size_t bytes) {
  const Open open(file);
  std::string text(bytes, '\0');
  std::size_t filled = 0;
  while (const std::size_t got = open.read(text.data() + filled, bytes - filled)) {
    filled += got;
  }
  text.resize(filled);
  return text;
}

} // namespace spricka::base
