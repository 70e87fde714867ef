// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/file.hpp"

#include <cerrno>
#include <cstdio>
#include <memory>
#include <system_error>

namespace spricka::report {
namespace {

[[noreturn]] void fail(const std::filesystem::path& file, int error) {
  throw std::system_error(error, std::generic_category(), "cannot write " + file.string());
}

struct Close {
  void operator()(std::FILE* f) const { std::fclose(f); }
};

} // namespace

void write_file(const std::filesystem::path& file, std::string_view bytes) {
  std::filesystem::path temporary = file;
  temporary += ".part";
  errno = 0;
  std::unique_ptr<std::FILE, Close> out(std::fopen(temporary.c_str(), "wb"));
  if (!out) {
    fail(file, errno);
  }
  const bool written = std::fwrite(bytes.data(), 1, bytes.size(), out.get()) == bytes.size();
  const int write_error = errno;
  // Closing flushes: a full disk may show only here.
  const bool closed = std::fclose(out.release()) == 0;
  if (!written || !closed) {
    const int error = written ? errno : write_error;
    std::error_code ignored;
    std::filesystem::remove(temporary, ignored);
    fail(file, error);
  }
  std::error_code renamed;
  std::filesystem::rename(temporary, file, renamed);
  if (renamed) {
    std::error_code ignored;
    std::filesystem::remove(temporary, ignored);
    throw std::system_error(renamed, "cannot write " + file.string());
  }
}

} // namespace spricka::report
