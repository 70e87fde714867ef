// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/trial.hpp"

#include <cerrno>
#include <cstdio>

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

namespace spricka::mesh {
namespace {

/// Bytes of address space the process holds, from /proc; 0 where that cannot be read.
std::size_t held() {
  std::size_t pages = 0;
  if (std::FILE* file = std::fopen("/proc/self/statm", "r")) {
    if (std::fscanf(file, "%zu", &pages) != 1) {
      pages = 0;
    }
    std::fclose(file);
  }
  return pages * static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
}

void be_silent() {
  const int nowhere = open("/dev/null", O_WRONLY | O_CLOEXEC);
  if (nowhere >= 0) {
    dup2(nowhere, STDOUT_FILENO);
    dup2(nowhere, STDERR_FILENO);
  }
}

} // namespace

bool ends_well(const std::function<void()>& work, std::size_t memory) {
  std::fflush(nullptr);
  const std::size_t before = held();
  const pid_t child = fork();
  if (child < 0) {
    return true;
  }
  if (child == 0) {
    be_silent();
    const rlimit no_core{0, 0};
    setrlimit(RLIMIT_CORE, &no_core);
    if (before > 0) {
      const rlimit space{before + memory, before + memory};
      setrlimit(RLIMIT_AS, &space);
    }
    int code = 0;
    try {
      work();
    } catch (...) { // too little memory
      code = 1;
    }
    _exit(code);
  }
  int status = 0;
  while (waitpid(child, &status, 0) < 0) {
    if (errno != EINTR) {
      return true;
    }
  }
  return WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

} // namespace spricka::mesh
