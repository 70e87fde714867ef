// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <algorithm>
#include <cstddef>
#include <functional>
#include <type_traits>
#include <utility>
#include <vector>

namespace spricka::base {

/// Calls task(0) .. task(count - 1), each exactly once, on at most `threads` threads. Tasks must
/// not share writable data; then the results do not depend on the number of threads. An exception
/// of the lowest failed index is thrown again after all threads have ended.
void parallel_for(std::size_t count, int threads, const std::function<void(std::size_t)>& task);

/// The threads that the calling thread may use for a piece of work, while this lives. A thread that
/// another has started may use itself alone, unless it is given more.
class ThreadShare {
public:
  explicit ThreadShare(int threads);
  ~ThreadShare();
  ThreadShare(const ThreadShare&) = delete;
  ThreadShare& operator=(const ThreadShare&) = delete;
  static int current();

private:
  int before_;
};

/// Calls task(begin, end) for all ranges of `portion` indices of [0, count), the last may be
/// shorter, on the threads of the caller's share. As for parallel_for.
void parallel_for_ranges(std::size_t count, std::size_t portion,
                         const std::function<void(std::size_t, std::size_t)>& task);

/// Calls use(i) for each element of [0, count), on the threads of the caller's share: each must
/// write what is its own.
template <class Use> void for_each_element(std::size_t count, const Use& use) {
  constexpr std::size_t portion = 64;
  parallel_for_ranges(count, portion, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      use(i);
    }
  });
}

/// Calls take(i, make(i)) for i = 0 .. count - 1 in this order, so that what take() adds up does
/// not depend on the threads. Of `batch` indices or more what they make is made on the threads of
/// the caller's share, a batch at a time; make() must write nothing that others read.
template <class Make, class Take>
void make_and_take_in_order(std::size_t count, std::size_t batch, const Make& make,
                            const Take& take) {
  if (ThreadShare::current() == 1 || count < batch) {
    for (std::size_t i = 0; i < count; ++i) {
      take(i, make(i));
    }
    return;
  }
  constexpr std::size_t portions = 64; // of a batch: enough that many threads end together
  std::vector<std::invoke_result_t<const Make&, std::size_t>> made(batch);
  for (std::size_t first = 0; first < count; first += batch) {
    const std::size_t now = std::min(batch, count - first);
    parallel_for_ranges(now, (now + portions - 1) / portions,
                        [&](std::size_t begin, std::size_t end) {
                          for (std::size_t i = begin; i < end; ++i) {
                            made[i] = make(first + i);
                          }
                        });
    for (std::size_t i = 0; i < now; ++i) {
      take(first + i, std::move(made[i]));
    }
  }
}

} // namespace spricka::base
