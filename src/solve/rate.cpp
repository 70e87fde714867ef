// SPDX-License-Identifier: GPL-3.0-or-later
#include "solve/rate.hpp"

#include "base/vec.hpp"
#include "solve/blas.hpp"

#include <algorithm>
#include <chrono>

namespace spricka::solve {

namespace {

double rate_of(int n, double seconds) {
  const base::Matrix A = base::Matrix::Constant(n, n, 1.0 / n);
  base::Matrix B = A;
  base::Matrix C(n, n);
  using Clock = std::chrono::steady_clock;
  const auto elapsed = [](Clock::time_point from) {
    return std::chrono::duration<double>(Clock::now() - from).count();
  };
  double best = 0.0;
  const Clock::time_point start = Clock::now();
  do { // the best of short stretches: others use the machine, too
    const Clock::time_point begin = Clock::now();
    int products = 0;
    do {
      blas::gemm({.m = n, .n = n, .k = n}, {A.data(), n}, {B.data(), n}, {C.data(), n});
      ++products;
    } while (elapsed(begin) < 0.1 * seconds);
    best = std::max(best, 2.0 * n * n * n * products / elapsed(begin));
  } while (elapsed(start) < seconds);
  return best;
}

} // namespace

FlopRate measure_flop_rate(double seconds) {
  blas::force_single_blas_thread();
  constexpr int small = 16;
  constexpr int large = 192;
  const double slow = rate_of(small, 0.3 * seconds);
  const double fast = rate_of(large, 0.7 * seconds);
  // rate(n) = peak n / (n + half) through both measurements
  constexpr double most = 0.6 * large / small; // beyond it something else took the time
  const double ratio = std::clamp(fast / slow, 1.0, most);
  const double half = (ratio - 1.0) / (1.0 / small - ratio / large);
  return {fast, fast * (large + half) / large, half};
}

} // namespace spricka::solve
