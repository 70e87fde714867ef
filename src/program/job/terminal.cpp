// SPDX-License-Identifier: GPL-3.0-or-later
#include "program/job/terminal.hpp"

#include <algorithm>
#include <cstdlib>
#include <string_view>

#include <sys/ioctl.h>
#include <unistd.h>

namespace spricka::program {

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
