// SPDX-License-Identifier: GPL-3.0-or-later
#include "program/job/written_out.hpp"

#include "program/job/log.hpp"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <iostream>
#include <string>

#include <fmt/format.h>

namespace spricka::program {

bool check_streams_written(LogFormat format) {
  errno = 0;
  std::cout.flush();
  const bool missing =
      std::fflush(stdout) != 0 || std::ferror(stdout) != 0 || std::cout.fail() || std::cout.bad();
  if (missing) {
    const std::string why = errno != 0 ? fmt::format(": {}", std::strerror(errno)) : "";
    Log(format).message(base::Severity::error, "E468", "standard output is incomplete" + why);
  }
  const bool silent = std::ferror(stderr) != 0;
  return !missing && !silent;
}

} // namespace spricka::program
