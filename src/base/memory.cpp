// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/memory.hpp"

#include <algorithm>
#include <fstream>
#include <string>

#include <sys/resource.h>
#include <unistd.h>

namespace spricka::base {

namespace {

// "max" or a number of bytes; control groups in both of their layouts.
std::size_t group_limit(std::size_t most) {
  for (const char* file :
       {"/sys/fs/cgroup/memory.max", "/sys/fs/cgroup/memory/memory.limit_in_bytes"}) {
    std::ifstream stream(file);
    std::size_t bytes = 0;
    if (stream >> bytes) {
      most = std::min(most, bytes);
    }
  }
  return most;
}

} // namespace

std::size_t process_memory_limit() {
  std::size_t most = static_cast<std::size_t>(sysconf(_SC_PHYS_PAGES)) *
                     static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
  for (const auto resource : {RLIMIT_AS, RLIMIT_DATA}) {
    rlimit limit{};
    if (getrlimit(resource, &limit) == 0 && limit.rlim_cur != RLIM_INFINITY) {
      most = std::min(most, static_cast<std::size_t>(limit.rlim_cur));
    }
  }
  return group_limit(most);
}

} // namespace spricka::base
