// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/clock.hpp"

#include <chrono>
#include <ctime>
#include <fstream>
#include <string>

#include <malloc.h>
#include <sys/resource.h>
#include <unistd.h>

namespace spricka::base {

double cpu_seconds() {
  timespec t{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

double steady_clock_seconds() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

void return_large_blocks_on_free() {
  // The pages of smaller blocks would be asked for anew with each matrix of a small model.
  constexpr int large = 16 * 1024 * 1024;
  mallopt(M_MMAP_THRESHOLD, large);
  mallopt(M_TRIM_THRESHOLD, 4 * large);
}

void return_free_memory_to_system() {
  if (4 * mallinfo2().fordblks > resident_memory()) {
    malloc_trim(0);
  }
}

std::optional<std::size_t> peak_memory_of_process(const std::string& process) {
  std::ifstream status("/proc/" + process + "/status");
  for (std::string word; status >> word;) {
    if (std::size_t kibibytes = 0; word == "VmHWM:" && status >> kibibytes) {
      return kibibytes * 1024;
    }
  }
  return std::nullopt;
}

std::size_t peak_memory() {
  if (const std::optional<std::size_t> own = peak_memory_of_process("self")) {
    return *own;
  }
  // Without /proc. It knows no less than the peak of the parent: a process that vfork or
  // posix_spawn made has run in the memory of that one until it became a program of its own.
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
