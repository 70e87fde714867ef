// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesher/sandbox.hpp"

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <initializer_list>
#include <memory>
#include <type_traits>

#include <sched.h>
#include <seccomp.h>
#include <sys/resource.h>
#include <unistd.h>

namespace spricka::mesher {
namespace {

/// A filter of system calls of this process. A call that none of its rules names is refused with
/// EPERM; one of a foreign convention (32 bits, x32) ends the process. A call that this processor
/// does not have needs no rule and gets none.
class SystemCallFilter {
public:
  SystemCallFilter() {
    const bool made = filter_ != nullptr;
    complete_ = made && set(SCMP_FLTATR_ACT_BADARCH, SCMP_ACT_KILL_PROCESS) &&
                set(SCMP_FLTATR_CTL_TSYNC, 1); // fails where the kernel has no such filters
  }
  /// What happens on each of these calls: an SCMP_ACT_.. .
  void add_rules(std::uint32_t action, std::initializer_list<const char*> calls) {
    for (const char* const call : calls) {
      complete_ = complete_ && seccomp_rule_add(filter_.get(), action, number(call), 0) == 0;
    }
  }
  /// The call is allowed where its first argument, of which the kernel reads 32 bits, is `value`.
  void allow_with_argument(const char* call, std::uint32_t value) {
    constexpr std::uint32_t all_bits = ~0U;
    const scmp_arg_cmp equal{
        .arg = 0, .op = SCMP_CMP_MASKED_EQ, .datum_a = all_bits, .datum_b = value};
    complete_ = complete_ &&
                seccomp_rule_add_array(filter_.get(), SCMP_ACT_ALLOW, number(call), 1, &equal) == 0;
  }
  /// The filter holds for all threads of the process from now on. False if it does not.
  [[nodiscard]] bool install() { return complete_ && seccomp_load(filter_.get()) == 0; }

private:
  static int number(const char* call) { return seccomp_syscall_resolve_name(call); }
  bool set(scmp_filter_attr attribute, std::uint32_t value) {
    return seccomp_attr_set(filter_.get(), attribute, value) == 0;
  }

  std::unique_ptr<std::remove_pointer_t<scmp_filter_ctx>, decltype(&seccomp_release)> filter_{
      seccomp_init(SCMP_ACT_ERRNO(EPERM)), &seccomp_release};
  bool complete_ = false; ///< every rule so far was taken
};

} // namespace

bool enter_sandbox() {
  SystemCallFilter filter;
  // What a program needs that only computes: memory; files that are open; signals and its end;
  // time; what it is itself.
  filter.add_rules(SCMP_ACT_ALLOW,
                   {"mmap", "munmap", "mremap", "mprotect", "madvise", "brk", "futex"});
  filter.add_rules(SCMP_ACT_ALLOW, {"read", "readv", "pread64", "pwrite64", "lseek", "ftruncate",
                                    "fstat", "dup", "close"});
  filter.add_rules(SCMP_ACT_ALLOW, {"rt_sigaction", "rt_sigprocmask", "rt_sigreturn", "sigaltstack",
                                    "restart_syscall", "exit", "exit_group"});
  filter.add_rules(SCMP_ACT_ALLOW, {"time", "gettimeofday", "clock_gettime", "clock_getres",
                                    "times", "getrusage", "sched_yield"});
  filter.add_rules(SCMP_ACT_ALLOW, {"getpid", "getppid", "gettid", "getuid", "geteuid", "getgid",
                                    "getegid", "sched_getaffinity", "sysinfo", "getrandom"});
  // Answered by the process itself, see only_file.hpp.
  filter.add_rules(SCMP_ACT_TRAP, {"openat", "newfstatat", "open", "stat", "access"});
  // Only an attack comes here; threads are not needed either.
  filter.add_rules(SCMP_ACT_KILL_PROCESS,
                   {"execve", "execveat", "socket", "connect", "ptrace", "process_vm_writev",
                    "fork", "vfork", "clone", "clone3"});
  filter.allow_with_argument("tgkill", static_cast<std::uint32_t>(getpid())); // abort()
  filter.allow_with_argument("prlimit64", 0);
  for (std::uint32_t descriptor = STDOUT_FILENO; descriptor <= 3; ++descriptor) {
    filter.allow_with_argument("write", descriptor);
    filter.allow_with_argument("writev", descriptor);
  }
  return filter.install();
}

void pin_to_one_processor() {
  const int here = sched_getcpu();
  if (here >= 0) {
    cpu_set_t one;
    CPU_ZERO(&one);
    CPU_SET(static_cast<std::size_t>(here), &one);
    sched_setaffinity(0, sizeof one, &one); // where it fails only threads are refused
  }
}

void limit_memory(std::size_t memory) {
  const rlimit none{0, 0};
  setrlimit(RLIMIT_CORE, &none);
#ifndef __SANITIZE_ADDRESS__ // its shadow is larger than any machine
  std::size_t pages = 0;
  if (std::FILE* file = std::fopen("/proc/self/statm", "r")) {
    if (std::fscanf(file, "%zu", &pages) != 1) {
      pages = 0;
    }
    std::fclose(file);
  }
  rlimit both{};
  getrlimit(RLIMIT_AS, &both);
  const rlim_t most = pages * static_cast<std::size_t>(sysconf(_SC_PAGESIZE)) + memory;
  both.rlim_cur = both.rlim_max == RLIM_INFINITY ? most : std::min<rlim_t>(most, both.rlim_max);
  both.rlim_max = both.rlim_cur;
  setrlimit(RLIMIT_AS, &both);
#else
  static_cast<void>(memory);
#endif
}

void limit_processor_time(double seconds) {
  rusage used{};
  getrusage(RUSAGE_SELF, &used);
  rlimit both{};
  getrlimit(RLIMIT_CPU, &both);
  const auto spent = used.ru_utime.tv_sec + used.ru_stime.tv_sec + 1;
  const auto most = static_cast<rlim_t>(spent) + static_cast<rlim_t>(std::ceil(seconds));
  both.rlim_cur = both.rlim_max == RLIM_INFINITY ? most : std::min(most, both.rlim_max);
  setrlimit(RLIMIT_CPU, &both);
}

} // namespace spricka::mesher
