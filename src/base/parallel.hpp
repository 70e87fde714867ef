// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <cstddef>
#include <functional>

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

} // namespace spricka::base
