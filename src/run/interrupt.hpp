// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <functional>
#include <thread>

#include <csignal>

namespace spricka::run {

/// While it lives, SIGINT and SIGTERM end the program in good order, however long the computation
/// takes at that moment: `last_words` is called with the signal on a thread of its own, then the
/// program ends with the code that it returns. At most one at a time.
class Interrupt {
public:
  explicit Interrupt(std::function<int(int signal)> last_words);
  ~Interrupt();
  Interrupt(const Interrupt&) = delete;
  Interrupt& operator=(const Interrupt&) = delete;

private:
  struct sigaction old_int_ {};
  struct sigaction old_term_ {};
  std::thread watcher_;
};

} // namespace spricka::run
