// SPDX-License-Identifier: GPL-3.0-or-later
#include "solve/one_thread.hpp"
#include "solve/blas.hpp"

#include <algorithm>
#include <atomic>
#include <new>
#include <vector>

#include <sys/mman.h>
#include <sys/resource.h>

extern "C" {
// Of OpenBLAS; another library does without.
void* blas_memory_alloc(int kind) __attribute__((weak));
void blas_memory_free(void* block) __attribute__((weak));
}

namespace spricka::solve {

namespace {

constexpr std::size_t workspace = std::size_t{128} << 20U; ///< of a thread [bytes] (OpenBLAS 0.3)

bool memory_is_limited() {
  for (const auto kind : {RLIMIT_AS, RLIMIT_DATA}) {
    rlimit limit{};
    if (getrlimit(kind, &limit) == 0 && limit.rlim_cur != RLIM_INFINITY) {
      return true;
    }
  }
  return false;
}

bool has_room(std::size_t bytes) {
  void* const block = mmap(nullptr, bytes, PROT_READ | PROT_WRITE,
                           MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
  if (block == MAP_FAILED) {
    return false;
  }
  munmap(block, bytes);
  return true;
}

} // namespace

void end_idle_threads() {
  blas::force_single_blas_thread();
}

int reserve_blas_workspace(int threads) {
  static std::atomic<int> reserved{0}; // blocks stay: a second solution has them already
  if (blas_memory_alloc == nullptr || blas_memory_free == nullptr || !memory_is_limited() ||
      reserved >= threads) {
    return threads;
  }
  // A quarter more: the library wants its blocks on whole pages and keeps some of its own.
  const auto fits = [](int count, std::size_t share) {
    return has_room(share * static_cast<std::size_t>(count) * workspace + workspace / 4);
  };
  int count = std::max(1, reserved.load());
  while (count < threads && fits(count + 1 - reserved, 2)) {
    ++count;
  }
  if (count > reserved && !fits(count - reserved, 1)) {
    throw std::bad_alloc();
  }
  std::vector<void*> blocks; // freed, they stay with the library
  blocks.reserve(static_cast<std::size_t>(count));
  for (int i = 0; i < count; ++i) {
    blocks.push_back(blas_memory_alloc(0));
  }
  for (void* const block : blocks) {
    blas_memory_free(block);
  }
  reserved = count;
  return count;
}

} // namespace spricka::solve
