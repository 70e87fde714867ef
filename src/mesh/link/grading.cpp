// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/link/grading.hpp"

#include "mesh/plane.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace spricka::mesh {

using base::Vec2;

double Grading::operator()(const Vec2& p) const {
  double least = std::numeric_limits<double>::max();
  for (const SizeSource& source : sources_) {
    least = std::min(least, source.size + growth_ * (p - source.at).norm());
  }
  return least;
}

std::vector<double> divide(const std::function<Vec2(double)>& x, double t0, double t1,
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
  const int count = std::max(1, static_cast<int>(std::floor(N.back() + 0.5 + same)));
  std::vector<double> ends{t0};
  std::size_t k = 1;
  for (int i = 1; i < count; ++i) {
    const double wanted = static_cast<double>(i) / count * N.back();
    while (N[k] < wanted) {
      ++k;
    }
    ends.push_back(t[k - 1] + (wanted - N[k - 1]) / (N[k] - N[k - 1]) * (t[k] - t[k - 1]));
  }
  ends.push_back(t1);
  return ends;
}

} // namespace spricka::mesh
