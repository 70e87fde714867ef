// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/vec.hpp"

#include <random>

namespace spricka::solve::test {

/// Random numbers that a seed repeats.
class Dice {
public:
  explicit Dice(unsigned seed) : engine_(seed) {}
  int whole(int from, int to) { return std::uniform_int_distribution<int>(from, to)(engine_); }
  bool chance(double p) { return real(0.0, 1.0) < p; }
  double real(double from, double to) {
    return std::uniform_real_distribution<double>(from, to)(engine_);
  }
  base::Matrix matrix(Eigen::Index r, Eigen::Index c) {
    return base::Matrix::NullaryExpr(r, c, [this] { return real(-1.0, 1.0); });
  }

private:
  std::mt19937 engine_;
};

} // namespace spricka::solve::test
