// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/surface/line_division.hpp"

#include "mesh/plane.hpp"

#include <algorithm>
#include <cmath>

namespace spricka::mesh {

std::vector<double> divide_length(double s0, double s1, const std::function<double(double)>& size) {
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
  const int count = std::max(1, static_cast<int>(std::floor(N.back() + 0.5 + same)));
  std::vector<double> ends{s0};
  std::size_t k = 1;
  for (int i = 1; i < count; ++i) {
    const double wanted = static_cast<double>(i) / count * N.back();
    while (N[k] < wanted) {
      ++k;
    }
    ends.push_back(s[k - 1] + (wanted - N[k - 1]) / (N[k] - N[k - 1]) * (s[k] - s[k - 1]));
  }
  ends.push_back(s1);
  return ends;
}

} // namespace spricka::mesh
