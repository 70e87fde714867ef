// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/surface/line_division.hpp"

#include "mesh/link/grading.hpp"

#include <algorithm>

namespace spricka::mesh {

std::vector<double> divide_line_by_size(double s0, double s1,
                                        const std::function<double(double)>& size) {
  // N(s) = integral of ds / h, in steps that are short against h
  constexpr double part = 0.05;
  std::vector<double> s{s0};
  std::vector<double> N{0.0};
  while (s.back() < s1) {
    const double now = s.back();
    const double step = std::max(part * size(now), 1e-5 * (s1 - s0));
    const double next = now + 1.5 * step > s1 ? s1 : now + step;
    N.push_back(N.back() + (next - now) / size(0.5 * (now + next)));
    s.push_back(next);
  }
  return divide_by_cumulative_count(s, N);
}

} // namespace spricka::mesh
