// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <condition_variable>
#include <cstddef>
#include <exception>
#include <functional>
#include <mutex>
#include <queue>
#include <utility>

namespace spricka::base {

/// Tasks that become ready while others run, by number; those with the largest urgency are taken
/// first. What a task writes may be read by those that it makes ready.
class ReadyQueue {
public:
  /// Makes a task ready; any thread may, also before run().
  void push(std::size_t task, double urgency);
  /// Calls work(task, worker) for each task that is ready or becomes so, on at most `threads`
  /// threads (workers 0 .. threads - 1), until none is left. An exception of a task ends the run
  /// and is thrown again when all threads have ended.
  void run(int threads, const std::function<void(std::size_t, std::size_t)>& work);

private:
  void serve(std::size_t worker, const std::function<void(std::size_t, std::size_t)>& work);

  std::mutex lock_;
  std::condition_variable change_;
  // Of two that are as urgent the one with the smaller number: what is first in memory.
  struct LessUrgent {
    bool operator()(const std::pair<double, std::size_t>& a,
                    const std::pair<double, std::size_t>& b) const {
      return a.first < b.first || (a.first == b.first && a.second > b.second);
    }
  };
  std::priority_queue<std::pair<double, std::size_t>, std::vector<std::pair<double, std::size_t>>,
                      LessUrgent>
      ready_;
  int running_ = 0;
  std::exception_ptr failure_;
};

} // namespace spricka::base
