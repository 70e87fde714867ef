// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/link/mesher_link.hpp"

#include "base/clock.hpp"
#include "mesh/link/mesher_limits.hpp"
#include "mesh/link/mesher_process.hpp"
#include "mesh/link/mesher_request.hpp"
#include "mesh/link/mesher_use.hpp"

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <memory>
#include <mutex>
#include <optional>
#include <system_error>
#include <utility>

#include <fmt/format.h>
#include <sys/wait.h>
#include <unistd.h>

namespace spricka::mesh {
namespace {

struct Mesher {
  std::mutex turn;
  std::unique_ptr<MesherProcess> process;
};

Mesher& mesher() {
  static Mesher one;
  return one;
}

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find('\n', at), text.size());
    if (end > at) {
      lines.push_back(text.substr(at, end - at));
    }
    at = end + 1;
  }
  return lines;
}

MesherAnswer trouble(MesherOutcome end, std::string text) {
  MesherAnswer answer;
  answer.end = end;
  answer.trouble = std::move(text);
  return answer;
}

/// What a mesher that is gone died of. Throws std::system_error for one that never began.
MesherAnswer post_mortem(int status, const std::vector<std::string>& words) {
  const auto said = [&](const char* what) {
    return std::any_of(words.begin(), words.end(), [&](const std::string& line) {
      return line.find(what) != std::string::npos;
    });
  };
  if (said("Out of memory") || said("bad_alloc")) {
    return trouble(MesherOutcome::no_memory, "gmsh needs more memory than it may have");
  }
  constexpr int not_loaded = 127; // of the loader of libraries
  if (WIFEXITED(status) && WEXITSTATUS(status) == not_loaded) {
    throw std::system_error(ENOEXEC, std::generic_category(),
                            words.empty() ? "cannot start gmsh" : words.back());
  }
  if (WIFEXITED(status)) {
    return trouble(MesherOutcome::left, "gmsh ended in the middle of its work");
  }
  switch (const int signal = WTERMSIG(status)) {
  case SIGSYS:
    return trouble(MesherOutcome::forbidden,
                   "gmsh tried to start a program or to reach the network, and was stopped");
  case SIGXCPU:
    return trouble(MesherOutcome::no_time, "gmsh took longer than it may");
  default:
    return trouble(MesherOutcome::crashed, fmt::format("gmsh crashed ({})", strsignal(signal)));
  }
}

class Exchange {
public:
  explicit Exchange(MesherProcess& process) : process_(process) {}

  MesherAnswer run(std::string_view request) {
    meshing_ = request.front() != static_cast<char>(MesherFrameKind::import) &&
               request.front() != static_cast<char>(MesherFrameKind::describe);
    process_.take_output(); // of earlier requests
    const double used = process_.processor_time();
    double waited = 0.0;
    base::Stopwatch since_look;
    double worked = used;
    if (!process_.send_frame(request)) {
      return gone();
    }
    while (true) {
      MesherAnswer answer;
      switch (process_.receive_frame(look_every, longest(), answer.frame)) {
      case MesherProcess::ReceiveResult::gone:
        return gone();
      case MesherProcess::ReceiveResult::too_long:
        return ended(trouble(MesherOutcome::no_memory, "the mesh is larger than memory allows"));
      case MesherProcess::ReceiveResult::frame:
        if (is(answer.frame, MesherFrameKind::meshing)) {
          meshing_ = true;
          break;
        }
        if (is(answer.frame, MesherFrameKind::no_memory)) {
          return ended(
              trouble(MesherOutcome::no_memory, "gmsh needs more memory than it may have"));
        }
        return answer;
      case MesherProcess::ReceiveResult::nothing:
        break;
      }
      // Of the clock only what it waits for by itself counts: other work on the machine may keep it
      // from a processor for any time.
      const double now = process_.processor_time();
      waited +=
          process_.is_sleeping() ? std::max(0.0, since_look.wall_time() - (now - worked)) : 0.0;
      since_look = {};
      worked = now;
      if (std::optional<MesherAnswer> late = too_late(now - used, waited)) {
        return ended(*std::move(late));
      }
    }
  }

private:
  static constexpr int look_every = 50; // ms

  static bool is(const std::string& frame, MesherFrameKind kind) {
    return !frame.empty() && frame.front() == static_cast<char>(kind);
  }
  static std::size_t longest() { return mesher_limits().memory; }

  [[nodiscard]] std::optional<MesherAnswer> too_late(double processor, double waited) const {
    const MesherLimits& limits = mesher_limits();
    const double may = meshing_ ? limits.seconds : limits.script_reading_seconds();
    const char* const doing = meshing_ ? "meshing" : "reading";
    if (processor > may) {
      return trouble(MesherOutcome::no_time,
                     fmt::format("{} took more than {:g} s of processor time", doing, may));
    }
    if (waited > limits.waiting) {
      return trouble(MesherOutcome::no_time,
                     fmt::format("{} has stood still for {:.0f} s", doing, waited));
    }
    return std::nullopt;
  }
  MesherAnswer gone() {
    const int status = process_.end();
    std::vector<std::string> words = lines_of(process_.take_output());
    MesherAnswer answer = post_mortem(status, words);
    answer.words = std::move(words);
    return answer;
  }
  MesherAnswer ended(MesherAnswer answer) {
    process_.end();
    answer.words = lines_of(process_.take_output());
    return answer;
  }

  MesherProcess& process_;
  bool meshing_ = false; ///< not reading a file
};

/// Ended from outside, not by what it was doing.
bool was_killed(const MesherAnswer& answer, MesherProcess& process) {
  if (answer.end != MesherOutcome::crashed) {
    return false;
  }
  const int status = process.end();
  return WIFSIGNALED(status) && (WTERMSIG(status) == SIGKILL || WTERMSIG(status) == SIGTERM);
}

} // namespace

MesherLimits& mesher_limits() {
  static MesherLimits limits = [] {
    MesherLimits l;
    constexpr std::size_t least = std::size_t{2} << 30U;
    const auto machine = static_cast<std::size_t>(std::max(0L, sysconf(_SC_PHYS_PAGES))) *
                         static_cast<std::size_t>(std::max(0L, sysconf(_SC_PAGESIZE)));
    l.memory = std::max(least, machine / 4);
    return l;
  }();
  return limits;
}

std::function<void(const MesherUsage&)>& mesher_listener() {
  static std::function<void(const MesherUsage&)> listener;
  return listener;
}

namespace {

MesherAnswer ask(Mesher& m, std::string_view request) {
  for (bool again : {true, false}) {
    if (m.process && !m.process->is_owner()) {
      m.process.reset(); // made before a fork; its owner goes on with it
    }
    if (!m.process) {
      m.process = MesherProcess::start(mesher_limits().memory);
    }
    MesherAnswer answer = Exchange(*m.process).run(request);
    if (answer.end == MesherOutcome::answered) {
      return answer;
    }
    again = again && was_killed(answer, *m.process);
    m.process.reset();
    if (!again) {
      return answer;
    }
  }
  return {};
}

} // namespace

MesherAnswer request_from_mesher(std::string_view request) {
  Mesher& m = mesher();
  const std::scoped_lock lock(m.turn);
  if (!mesher_listener()) {
    return ask(m, request);
  }
  const base::Stopwatch watch;
  // One that is started for this request has all of its time from it.
  const double used = m.process && m.process->is_owner() ? m.process->processor_time() : 0.0;
  MesherAnswer answer = ask(m, request);
  MesherUsage use{
      .begin = watch.start_time(), .end = base::steady_clock_seconds(), .cpu = {}, .peak = {}};
  if (m.process) {
    use.cpu = std::max(0.0, m.process->processor_time() - used);
    use.peak = m.process->peak_memory();
  }
  mesher_listener()(use);
  return answer;
}

void end_mesher_process() {
  Mesher& m = mesher();
  const std::scoped_lock lock(m.turn);
  m.process.reset();
}

} // namespace spricka::mesh
