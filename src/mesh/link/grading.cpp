// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/link/grading.hpp"

#include "mesh/plane.hpp"

#include <cmath>

namespace spricka::mesh {

using base::Vec2;

std::vector<double> divide_by_cumulative_count(const std::vector<double>& s,
                                               const std::vector<double>& N) {
  const int count =
      std::max(1, static_cast<int>(std::floor(N.back() + 0.5 + coordinate_tolerance)));
  std::vector<double> ends{s.front()};
  std::size_t k = 1;
  for (int i = 1; i < count; ++i) {
    const double wanted = static_cast<double>(i) / count * N.back();
    while (N[k] < wanted) {
      ++k;
    }
    ends.push_back(s[k - 1] + (wanted - N[k - 1]) / (N[k] - N[k - 1]) * (s[k] - s[k - 1]));
  }
  ends.push_back(s.back());
  return ends;
}

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

std::vector<double> divide_curve_by_size(const std::function<Vec2(double)>& x, double t0, double t1,
                                         const Grading& size) {
  // N(t) = integral of ds / h, in steps that are short against h
  constexpr double part = 0.05;
  std::vector<double> t{t0};
  std::vector<double> N{0.0};
  while (t.back() < t1) {
    const double now = t.back();
    const double small = 1e-6 * (t1 - t0);
    const double speed = (x(now + small) - x(now)).norm() / small;
    double next = now + part * size(x(now)) / speed;
    if (next > t1 - 0.5 * (next - now)) {
      next = t1;
    }
    const double h = size(x(0.5 * (now + next)));
    N.push_back(N.back() + (x(next) - x(now)).norm() / h);
    t.push_back(next);
  }
  return divide_by_cumulative_count(t, N);
}

} // namespace spricka::mesh
