// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesher/sandbox.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <vector>

#include <linux/audit.h>
#include <linux/filter.h>
#include <linux/seccomp.h>
#include <sched.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <unistd.h>

namespace spricka::mesher {
namespace {

#if defined(__x86_64__)
constexpr std::uint32_t machine = AUDIT_ARCH_X86_64;
#elif defined(__aarch64__)
constexpr std::uint32_t machine = AUDIT_ARCH_AARCH64;
#else
constexpr std::uint32_t machine = 0;
#endif

/// A filter of the kernel: instructions of the classic Berkeley packet filter on seccomp_data.
/// Source: Linux, Documentation/userspace-api/seccomp_filter.rst.
class Filter {
public:
  Filter() {
    load(offsetof(seccomp_data, arch));
    skip_unless(BPF_JEQ, machine, 1);
    jump_over(1);
    end(SECCOMP_RET_KILL_PROCESS);
    load(offsetof(seccomp_data, nr));
#if defined(__x86_64__)
    constexpr std::uint32_t x32 = 0x40000000U; // calls of another convention, under other numbers
    skip_unless(BPF_JGE, x32, 1);
    end(SECCOMP_RET_KILL_PROCESS);
#endif
  }
  /// This is what happens on a call.
  void on(long call, std::uint32_t action) {
    skip_unless(BPF_JEQ, static_cast<std::uint32_t>(call), 1);
    end(action);
  }
  /// The call is allowed if its argument lies between two values, else refused with an error.
  void between(long call, std::size_t argument, std::uint32_t low, std::uint32_t high) {
    constexpr std::uint8_t length = 5;
    skip_unless(BPF_JEQ, static_cast<std::uint32_t>(call), length);
    load(static_cast<std::uint32_t>(offsetof(seccomp_data, args) + 8 * argument));
    skip_unless(BPF_JGE, low, 2); // to the refusal
    add(BPF_JMP | BPF_JGT | BPF_K, high, 1, 0);
    end(SECCOMP_RET_ALLOW);
    end(SECCOMP_RET_ERRNO | EPERM);
  }
  void end(std::uint32_t action) {
    add(BPF_RET | BPF_K, action, 0, 0);
  }

  [[nodiscard]] bool install() {
    const sock_fprog program{static_cast<unsigned short>(code_.size()), code_.data()};
    return machine != 0 && prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) == 0 &&
           syscall(SYS_seccomp, SECCOMP_SET_MODE_FILTER, SECCOMP_FILTER_FLAG_TSYNC, &program) == 0;
  }

private:
  void add(int what, std::uint32_t value, std::uint8_t if_true, std::uint8_t if_false) {
    code_.push_back({static_cast<std::uint16_t>(what), if_true, if_false, value});
  }
  void load(std::uint32_t offset) {
    add(BPF_LD | BPF_W | BPF_ABS, offset, 0, 0);
  }
  void skip_unless(int comparison, std::uint32_t value, std::uint8_t count) {
    add(BPF_JMP | comparison | BPF_K, value, 0, count);
  }
  void jump_over(std::uint32_t count) {
    add(BPF_JMP | BPF_JA, count, 0, 0);
  }

  std::vector<sock_filter> code_;
};

// What a program needs that only computes.
constexpr std::array harmless{
    SYS_read,
    SYS_mmap,
    SYS_pwrite64,
    SYS_pread64,
    SYS_readv,
    SYS_close,
    SYS_fstat,
    SYS_lseek,
    SYS_ftruncate,
    SYS_dup,
    SYS_munmap,
    SYS_mremap,
    SYS_brk,
    SYS_madvise,
    SYS_futex,
    SYS_rt_sigaction,
    SYS_rt_sigprocmask,
    SYS_rt_sigreturn,
    SYS_sigaltstack,
    SYS_exit,
    SYS_exit_group,
    SYS_clock_gettime,
    SYS_clock_getres,
    SYS_gettimeofday,
    SYS_getrusage,
    SYS_times,
    SYS_sched_yield,
    SYS_getpid,
    SYS_getppid,
    SYS_gettid,
    SYS_getuid,
    SYS_geteuid,
    SYS_getgid,
    SYS_getegid,
    SYS_sysinfo,
    SYS_getrandom,
    SYS_restart_syscall,
    SYS_mprotect,
    SYS_sched_getaffinity,
#ifdef SYS_time
    SYS_time,
#endif
};

// Answered by the process itself, see only_file.hpp.
constexpr std::array of_files{
    SYS_openat, SYS_newfstatat,
#ifdef SYS_open
    SYS_open,   SYS_stat,       SYS_access,
#endif
};

// Only an attack comes here.
constexpr std::array hostile{
    SYS_execve, SYS_execveat, SYS_socket, SYS_connect, SYS_ptrace, SYS_process_vm_writev,
#ifdef SYS_fork
    SYS_fork,   SYS_vfork,
#endif
};

} // namespace

bool enter_sandbox() {
  Filter filter;
  for (const long call : harmless) {
    filter.on(call, SECCOMP_RET_ALLOW);
  }
  for (const long call : of_files) {
    filter.on(call, SECCOMP_RET_TRAP);
  }
  for (const long call : hostile) {
    filter.on(call, SECCOMP_RET_KILL_PROCESS);
  }
  filter.on(SYS_clone, SECCOMP_RET_KILL_PROCESS); // threads are not needed either
  filter.on(SYS_clone3, SECCOMP_RET_KILL_PROCESS);
  const auto self = static_cast<std::uint32_t>(getpid());
  filter.between(SYS_tgkill, 0, self, self); // abort()
  filter.between(SYS_prlimit64, 0, 0, 0);
  filter.between(SYS_write, 0, STDOUT_FILENO, 3);
  filter.between(SYS_writev, 0, STDOUT_FILENO, 3);
  filter.end(SECCOMP_RET_ERRNO | EPERM);
  return filter.install();
}

void stay_on_one_processor() {
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

void limit_time(double seconds) {
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
