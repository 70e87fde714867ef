// SPDX-License-Identifier: GPL-3.0-or-later
#include "run/safe_file.hpp"

#include "run/hasher.hpp"

#include <cerrno>
#include <charconv>
#include <cstring>
#include <fstream>
#include <iterator>
#include <utility>
#include <vector>

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

namespace spricka::run {

namespace {

namespace fs = std::filesystem;

constexpr int format_version = 1;

[[noreturn]] void cannot_write(const fs::path& file, int error) {
  throw FileTrouble("E563", fmt::format("{}: {}", file.string(), std::strerror(error)));
}

/// An open file or folder.
class Descriptor {
public:
  Descriptor(const fs::path& file, int flags) : fd_(::open(file.c_str(), flags, 0666)) {}
  ~Descriptor() {
    if (fd_ >= 0) {
      ::close(fd_);
    }
  }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  [[nodiscard]] int get() const { return fd_; }
  bool close() { return ::close(std::exchange(fd_, -1)) == 0; }

private:
  int fd_;
};

bool write_all(int fd, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t n = ::write(fd, bytes.data(), bytes.size());
    if (n < 0 && errno != EINTR) {
      return false;
    }
    bytes.remove_prefix(n > 0 ? static_cast<std::size_t>(n) : 0);
  }
  return true;
}

// A folder that cannot be synced (some network file systems) is none of ours to mend.
void sync_folder(const fs::path& folder) {
  const Descriptor open(folder.empty() ? fs::path(".") : folder, O_RDONLY | O_DIRECTORY);
  if (open.get() >= 0) {
    ::fsync(open.get());
  }
}

[[noreturn]] void unusable(const fs::path& file, const std::string& why,
                           const char* code = "E560") {
  throw FileTrouble(code, fmt::format("{}: {}", file.string(), why));
}

std::vector<std::string> words(std::string_view line) {
  std::vector<std::string> list;
  while (!line.empty()) {
    const std::size_t end = std::min(line.find(' '), line.size());
    list.emplace_back(line.substr(0, end));
    line.remove_prefix(std::min(end + 1, line.size()));
  }
  return list;
}

// spricka state 1 of 0.1.0, 12345 bytes, xxh3 0123...
constexpr std::size_t line_words = 9;

} // namespace

void write_safely(const fs::path& file, std::string_view bytes) {
  fs::path part = file;
  part += ".part";
  Descriptor out(part, O_WRONLY | O_CREAT | O_TRUNC);
  if (out.get() < 0) {
    cannot_write(part, errno);
  }
  if (!write_all(out.get(), bytes) || ::fsync(out.get()) != 0 || !out.close() ||
      ::rename(part.c_str(), file.c_str()) != 0) {
    const int error = errno;
    ::unlink(part.c_str());
    cannot_write(file, error);
  }
  sync_folder(file.parent_path());
}

std::string hash_of(std::string_view bytes) {
  Hasher hash;
  hash.add(bytes.data(), bytes.size());
  const auto [high, low] = hash.key();
  return fmt::format("{:016x}{:016x}", high, low);
}

std::string framed(std::string_view kind, std::string_view bytes) {
  std::string out = fmt::format("spricka {} {} of {} , {} bytes {}", kind, format_version,
                                SPRICKA_VERSION, bytes.size(), hash_of(bytes));
  out.resize(frame_size - 1, ' ');
  out += '\n';
  out += bytes;
  return out;
}

std::string read_framed(const fs::path& file, std::string_view kind) {
  std::ifstream in(file, std::ios::binary);
  if (!in || !fs::is_regular_file(file)) {
    unusable(file, "there is no such file");
  }
  std::string bytes{std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
  if (in.bad()) {
    unusable(file, "cannot be read");
  }
  const std::string start = fmt::format("spricka {} ", kind);
  if (bytes.size() < frame_size && (bytes.starts_with(start) || start.starts_with(bytes))) {
    unusable(file, "cut off in its first line");
  }
  if (!bytes.starts_with(start)) {
    unusable(file, fmt::format("not a {} of spricka", kind), "E564");
  }
  const std::vector<std::string> line = words(std::string_view(bytes).substr(0, frame_size - 1));
  if (line.size() < line_words || line[2] != std::to_string(format_version) ||
      line[4] != SPRICKA_VERSION) {
    unusable(file,
             fmt::format("written by spricka {} in format {}; this is {} with format {}",
                         line.size() > 4 ? line[4] : "?", line.size() > 2 ? line[2] : "?",
                         SPRICKA_VERSION, format_version),
             "E565");
  }
  std::size_t size = 0;
  std::from_chars(line[6].data(), line[6].data() + line[6].size(), size);
  const std::string_view body = std::string_view(bytes).substr(frame_size);
  if (body.size() < size) {
    unusable(file, fmt::format("cut off: {} of {} bytes are there", body.size(), size));
  }
  if (body.size() > size || hash_of(body) != line[8]) {
    unusable(file, "its content was changed");
  }
  return std::string(body);
}

} // namespace spricka::run
