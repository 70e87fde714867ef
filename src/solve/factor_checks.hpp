// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <cmath>
#include <cstdint>
#include <ctime>
#include <limits>

namespace spricka::solve {

/// CPU time of the calling thread [s]: nets are condensed side by side, each on one thread.
inline double thread_cpu_seconds() {
  timespec t{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

/// A pivot that is round-off of its diagonal entry says that the locals can move freely: errors of
/// a factorisation of n rows are a few eps sqrt(n) of the diagonal.
inline double smallest_allowed_pivot(std::int64_t n) {
  return 64.0 * std::numeric_limits<double>::epsilon() * std::sqrt(static_cast<double>(n));
}

} // namespace spricka::solve
