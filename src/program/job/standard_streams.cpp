// SPDX-License-Identifier: GPL-3.0-or-later
#include "program/job/standard_streams.hpp"

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstdlib>

#include <fcntl.h>
#include <sys/ioctl.h>
#include <unistd.h>

namespace spricka::program {

void ensure_standard_streams_open() {
  for (const int fd : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
    if (::fcntl(fd, F_GETFD) < 0 && errno == EBADF) {
      // the lowest number that is free is this one
      [[maybe_unused]] const int opened =
          ::open("/dev/null", fd == STDIN_FILENO ? O_WRONLY : O_RDONLY);
    }
  }
}

void write_to_stdout(std::string_view text) {
  std::fwrite(text.data(), 1, text.size(), stdout);
}

void write_to_stderr(std::string_view text) {
  std::fwrite(text.data(), 1, text.size(), stderr);
}

namespace {

std::string_view environment(const char* name) {
  const char* value = std::getenv(name);
  return value == nullptr ? std::string_view() : std::string_view(value);
}

} // namespace

base::MessageColour message_colour() {
  const bool plain = isatty(STDERR_FILENO) == 0 || !environment("NO_COLOR").empty() ||
                     environment("TERM") == "dumb";
  return plain ? base::MessageColour::none : base::MessageColour::terminal;
}

std::size_t text_columns() {
  constexpr std::size_t usual = 100;
  constexpr std::size_t widest = 110; // longer lines are hard to read
  constexpr std::size_t narrowest = 40;
  winsize size{};
  if (ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) != 0 || size.ws_col == 0) {
    return usual;
  }
  return std::clamp<std::size_t>(size.ws_col, narrowest, widest);
}

} // namespace spricka::program
