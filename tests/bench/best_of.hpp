// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/clock.hpp"

#include <algorithm>
#include <limits>

/// The CPU seconds of a piece of work, the least of several times.
namespace spricka::bench {

template <class Work> double best_of(int repeats, Work&& work) {
  double best = std::numeric_limits<double>::infinity();
  for (int i = 0; i < repeats; ++i) {
    const base::Stopwatch watch;
    work();
    best = std::min(best, watch.cpu_time());
  }
  return best;
}

} // namespace spricka::bench
