// SPDX-License-Identifier: GPL-3.0-or-later
#include "program/job/interrupt.hpp"

#include "solve/scratch_folder.hpp"

#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <utility>

#include <semaphore.h>

namespace spricka::program {

namespace {

// A signal handler reaches nothing but what is static. Libraries start threads of their own before
// main(), so blocking the signals everywhere and sigwait() are no way round.
sem_t woken;                             // NOLINT
volatile std::sig_atomic_t received = 0; // NOLINT: 0 when the owner is done

void on_signal(int signal) {
  // The interrupted code may be about to read its errno.
  const int before = errno;
  received = signal;
  sem_post(&woken);
  errno = before;
}

} // namespace

InterruptHandler::InterruptHandler(std::function<int(int signal)> last_words) {
  sem_init(&woken, 0, 0);
  received = 0;
  watcher_ = std::thread([words = std::move(last_words)] {
    while (sem_wait(&woken) != 0) { // a handler ran on this thread
    }
    if (received == 0) {
      return;
    }
    const int code = words(received);
    solve::remove_scratch_folder();
    std::fflush(nullptr);
    // No destructors: other threads are still at work on what they would take away.
    std::_Exit(code);
  });
  struct sigaction action {};
  action.sa_handler = on_signal;
  sigemptyset(&action.sa_mask);
  action.sa_flags = SA_RESTART;
  for (std::size_t i = 0; i < signals.size(); ++i) {
    sigaction(signals[i], &action, &before_[i]);
    if (before_[i].sa_handler == SIG_IGN) { // nohup and background jobs: stays so
      sigaction(signals[i], &before_[i], nullptr);
    }
  }
}

InterruptHandler::~InterruptHandler() {
  for (std::size_t i = 0; i < signals.size(); ++i) {
    sigaction(signals[i], &before_[i], nullptr);
  }
  sem_post(&woken);
  watcher_.join();
  sem_destroy(&woken);
}

} // namespace spricka::program
