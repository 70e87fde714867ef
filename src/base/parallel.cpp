// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/parallel.hpp"

#include <algorithm>
#include <atomic>
#include <exception>
#include <system_error>
#include <thread>
#include <vector>

namespace spricka::base {

namespace {

thread_local int thread_share = 1;

} // namespace

ThreadShare::ThreadShare(int threads) : before_(thread_share) {
  thread_share = std::max(1, threads);
}

ThreadShare::~ThreadShare() {
  thread_share = before_;
}

int ThreadShare::current() {
  return thread_share;
}

void parallel_for_ranges(std::size_t count, std::size_t portion,
                         const std::function<void(std::size_t, std::size_t)>& task) {
  const std::size_t ranges = (count + portion - 1) / portion;
  const int threads = thread_share;
  const auto one = [&](std::size_t i) {
    const ThreadShare own(1); // what a range calls has no threads to share out
    task(i * portion, std::min(count, (i + 1) * portion));
  };
  parallel_for(ranges, threads, one);
}

void parallel_for(std::size_t count, int threads, const std::function<void(std::size_t)>& task) {
  std::vector<std::exception_ptr> failure(count);
  std::atomic<std::size_t> next{0};
  const auto work = [&] {
    for (std::size_t i = next++; i < count; i = next++) {
      try {
        task(i);
      } catch (...) {
        failure[i] = std::current_exception();
      }
    }
  };
  const std::size_t helpers = std::min(static_cast<std::size_t>(std::max(threads, 1)), count);
  std::vector<std::jthread> pool;
  for (std::size_t t = 1; t < helpers; ++t) {
    try {
      pool.emplace_back(work);
    } catch (const std::system_error&) {
      break; // no room for one more thread: those that are there do its share
    }
  }
  work();
  pool.clear(); // joins
  for (const std::exception_ptr& e : failure) {
    if (e) {
      std::rethrow_exception(e);
    }
  }
}

} // namespace spricka::base
