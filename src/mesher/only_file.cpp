// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesher/only_file.hpp"

#include <array>
#include <cerrno>
#include <csignal>
#include <cstdint>
#include <cstring>
#include <string>

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <ucontext.h>
#include <unistd.h>

namespace spricka::mesher {
namespace {

/// Openings of the file, each with a position of its own: gmsh may read it twice at a time.
constexpr std::size_t openings = 8;

// Plain data, as a signal handler looks at it.
std::array<int, openings> handles{};
std::size_t next = 0;
int memory_file = -1;
std::array<char, 256> name{};

bool is_the_file(const char* asked) {
  return asked != nullptr && name[0] != '\0' && std::strcmp(asked, name.data()) == 0;
}

long opened(const char* asked, long flags) {
  if (!is_the_file(asked) || (flags & (O_ACCMODE | O_CREAT | O_TRUNC)) != O_RDONLY) {
    return -EACCES;
  }
  next = (next + 1) % openings;
  const int fd = dup(handles[next]);
  return fd < 0 ? -errno : lseek(fd, 0, SEEK_SET) < 0 ? -errno : fd;
}

// The library's fstat() would be the call that is being answered.
long status_of(int fd, struct stat* result) {
  return syscall(SYS_fstat, fd, result) == 0 ? 0 : -errno;
}

long status(const char* asked, struct stat* result) {
  return is_the_file(asked) && result != nullptr ? status_of(handles[0], result) : -EACCES;
}

long answer(long call, const std::array<std::uintptr_t, 4>& a) {
  // The kernel hands over addresses as numbers.
  // NOLINTBEGIN(performance-no-int-to-ptr)
  const auto text = [&](std::size_t i) { return reinterpret_cast<const char*>(a[i]); };
  const auto place = [&](std::size_t i) { return reinterpret_cast<struct stat*>(a[i]); };
  // NOLINTEND(performance-no-int-to-ptr)
  switch (call) {
  case SYS_openat:
    return opened(text(1), static_cast<long>(a[2]));
  case SYS_newfstatat: // an empty name asks for the descriptor itself
    return text(1) != nullptr && *text(1) == '\0' ? status_of(static_cast<int>(a[0]), place(2))
                                                  : status(text(1), place(2));
#ifdef SYS_open
  case SYS_open:
    return opened(text(0), static_cast<long>(a[1]));
  case SYS_stat:
    return status(text(0), place(1));
  case SYS_access:
    return is_the_file(text(0)) && (a[1] & W_OK) == 0 ? 0 : -EACCES;
#endif
  default:
    return -EACCES;
  }
}

// The kernel has not done the call; what stands in the register of its result is what the caller
// gets.
void on_call(int /*signal*/, siginfo_t* info, void* context) {
  const int kept = errno;
  auto* const machine = static_cast<ucontext_t*>(context);
#if defined(__x86_64__)
  auto& r = machine->uc_mcontext.gregs;
  const auto arg = [&](int i) { return static_cast<std::uintptr_t>(r[i]); };
  r[REG_RAX] = answer(info->si_syscall, {arg(REG_RDI), arg(REG_RSI), arg(REG_RDX), arg(REG_R10)});
#elif defined(__aarch64__)
  auto& r = machine->uc_mcontext.regs;
  r[0] = static_cast<std::uint64_t>(answer(info->si_syscall, {r[0], r[1], r[2], r[3]}));
#endif
  errno = kept;
}

} // namespace

bool make_memory_file() {
#if !defined(__x86_64__) && !defined(__aarch64__)
  return false; // where an answer goes is known of these two only
#endif
  memory_file = memfd_create("spricka", MFD_CLOEXEC);
  if (memory_file < 0) {
    return false;
  }
  const std::string path = "/proc/self/fd/" + std::to_string(memory_file);
  for (int& handle : handles) {
    handle = open(path.c_str(), O_RDONLY | O_CLOEXEC);
    if (handle < 0 && (handle = dup(memory_file)) < 0) { // without /proc: one position for all
      return false;
    }
  }
  struct sigaction action {};
  action.sa_sigaction = on_call;
  action.sa_flags = SA_SIGINFO | SA_NODEFER;
  return sigaction(SIGSYS, &action, nullptr) == 0;
}

bool set_memory_file(const std::string& file, std::string_view text) {
  if (file.size() >= name.size() || ftruncate(memory_file, 0) != 0) {
    return false;
  }
  std::strncpy(name.data(), file.c_str(), name.size() - 1);
  for (std::size_t done = 0; done < text.size();) {
    const ssize_t written =
        pwrite(memory_file, text.data() + done, text.size() - done, static_cast<off_t>(done));
    if (written <= 0) {
      return false;
    }
    done += static_cast<std::size_t>(written);
  }
  return true;
}

} // namespace spricka::mesher
