// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/clock.hpp"

#include <ctime>
#include <fstream>
#include <malloc.h>
#include <sys/resource.h>
#include <unistd.h>

namespace spricka::base {

double cpu_seconds() {
  timespec t{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

void return_large_blocks() {
  // The pages of smaller blocks would be asked for anew with each matrix of a small model.
  constexpr int large = 16 * 1024 * 1024;
  mallopt(M_MMAP_THRESHOLD, large);
  mallopt(M_TRIM_THRESHOLD, 4 * large);
}

void return_free_memory() {
  if (4 * mallinfo2().fordblks > resident_memory()) {
    malloc_trim(0);
  }
}

std::size_t peak_memory() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<std::size_t>(usage.ru_maxrss) * 1024; // Linux counts KiB
}

std::size_t resident_memory() {
  std::size_t pages = 0;
  std::size_t resident = 0;
  std::ifstream statm("/proc/self/statm");
  if (!(statm >> pages >> resident)) {
    return 0;
  }
  return resident * static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
}

} // namespace spricka::base
