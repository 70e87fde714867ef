// SPDX-License-Identifier: GPL-3.0-or-later
#include "program/job/standard_streams.hpp"

#include "base/exit_codes.hpp"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <iostream>
#include <string>

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

namespace spricka::program {

void open_standard_streams() {
  for (const int fd : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
    if (::fcntl(fd, F_GETFD) < 0 && errno == EBADF) {
      // the lowest number that is free is this one
      [[maybe_unused]] const int opened =
          ::open("/dev/null", fd == STDIN_FILENO ? O_WRONLY : O_RDONLY);
    }
  }
}

void to_stdout(std::string_view text) {
  std::fwrite(text.data(), 1, text.size(), stdout);
}

void to_stderr(std::string_view text) {
  std::fwrite(text.data(), 1, text.size(), stderr);
}

int written_out(int code, LogFormat format) {
  errno = 0;
  std::cout.flush();
  const bool lost =
      std::fflush(stdout) != 0 || std::ferror(stdout) != 0 || std::cout.fail() || std::cout.bad();
  if (lost) {
    const std::string why = errno != 0 ? fmt::format(": {}", std::strerror(errno)) : "";
    Log(format).message(base::Severity::error, "E468", "standard output is incomplete" + why);
  }
  const bool silent = std::ferror(stderr) != 0;
  return code == base::exit_code::done && (lost || silent) ? base::exit_code::file_trouble : code;
}

} // namespace spricka::program
