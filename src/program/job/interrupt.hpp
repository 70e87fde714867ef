// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <array>
#include <functional>
#include <thread>

#include <csignal>

namespace spricka::program {

/// While it lives, SIGINT, SIGTERM, SIGHUP, SIGXCPU (a limit of CPU time) and SIGPIPE (a reader
/// that is gone) end the program in good order, however long the computation takes at that moment:
/// `last_words` is called with the signal on a thread of its own, then the program ends with the
/// code that it returns. At most one at a time.
class InterruptHandler {
public:
  explicit InterruptHandler(std::function<int(int signal)> last_words);
  ~InterruptHandler();
  InterruptHandler(const InterruptHandler&) = delete;
  InterruptHandler& operator=(const InterruptHandler&) = delete;

private:
  static constexpr std::array signals{SIGINT, SIGTERM, SIGHUP, SIGXCPU, SIGPIPE};
  std::array<struct sigaction, signals.size()> before_{};
  std::thread watcher_;
};

} // namespace spricka::program
