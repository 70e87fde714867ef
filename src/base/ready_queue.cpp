// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/ready_queue.hpp"

#include <algorithm>
#include <system_error>
#include <thread>
#include <vector>

namespace spricka::base {

void ReadyQueue::push(std::size_t task, double urgency) {
  {
    const std::lock_guard<std::mutex> guard(lock_);
    ready_.emplace(urgency, task);
  }
  change_.notify_one();
}

void ReadyQueue::serve(std::size_t worker,
                       const std::function<void(std::size_t, std::size_t)>& work) {
  std::unique_lock<std::mutex> guard(lock_);
  for (;;) {
    // A task under way may still make others ready.
    change_.wait(guard, [this] { return failure_ || !ready_.empty() || running_ == 0; });
    if (failure_ || ready_.empty()) {
      break;
    }
    const std::size_t task = ready_.top().second;
    ready_.pop();
    ++running_;
    guard.unlock();
    std::exception_ptr failed;
    try {
      work(task, worker);
    } catch (...) {
      failed = std::current_exception();
    }
    guard.lock();
    --running_;
    failure_ = failure_ ? failure_ : failed;
  }
  guard.unlock();
  change_.notify_all();
}

void ReadyQueue::run(int threads, const std::function<void(std::size_t, std::size_t)>& work) {
  std::vector<std::jthread> helpers;
  for (int t = 1; t < threads; ++t) {
    try {
      helpers.emplace_back([this, t, &work] { serve(static_cast<std::size_t>(t), work); });
    } catch (const std::system_error&) {
      break; // no room for one more thread: those that are there do its share
    }
  }
  serve(0, work);
  helpers.clear(); // joins
  if (const std::exception_ptr failure = std::exchange(failure_, nullptr)) {
    ready_ = {};
    std::rethrow_exception(failure);
  }
}

} // namespace spricka::base
