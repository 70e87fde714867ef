// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/memory.hpp"

#include <algorithm>
#include <atomic>
#include <fstream>
#include <limits>
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

std::atomic<std::size_t> processes_alike = 1; // NOLINT: a fact of this process

/// What this process takes now [bytes], as the limits count it.
struct MemoryInUse {
  std::size_t resident = 0, address_space = 0, data = 0;
};

MemoryInUse memory_in_use() {
  const auto page = static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
  std::ifstream statm("/proc/self/statm");
  std::size_t shared = 0;
  std::size_t text = 0;
  std::size_t library = 0;
  MemoryInUse pages;
  if (!(statm >> pages.address_space >> pages.resident >> shared >> text >> library >>
        pages.data)) {
    return {};
  }
  return {page * pages.resident, page * pages.address_space, page * pages.data};
}

std::size_t limit_of(decltype(RLIMIT_AS) resource, std::size_t most) {
  rlimit limit{};
  const bool limited = getrlimit(resource, &limit) == 0 && limit.rlim_cur != RLIM_INFINITY;
  return limited ? std::min(most, static_cast<std::size_t>(limit.rlim_cur)) : most;
}

// Of the machine or the control group, what is this process's.
std::size_t memory_share() {
  return group_limit(static_cast<std::size_t>(sysconf(_SC_PHYS_PAGES)) *
                     static_cast<std::size_t>(sysconf(_SC_PAGESIZE))) /
         processes_alike;
}

} // namespace

void divide_memory_limit(int processes) {
  processes_alike = static_cast<std::size_t>(std::max(processes, 1));
}

std::size_t process_memory_limit() {
  return limit_of(RLIMIT_AS, limit_of(RLIMIT_DATA, memory_share()));
}

double available_memory() {
  constexpr std::size_t unlimited = std::numeric_limits<std::size_t>::max();
  const MemoryInUse used = memory_in_use();
  const auto left = [](std::size_t limit, std::size_t in_use) {
    return static_cast<double>(limit) - static_cast<double>(in_use);
  };
  return std::min({left(memory_share(), used.resident),
                   left(limit_of(RLIMIT_AS, unlimited), used.address_space),
                   left(limit_of(RLIMIT_DATA, unlimited), used.data)});
}

} // namespace spricka::base
