// SPDX-License-Identifier: GPL-3.0-or-later
#include "life/newman_closure.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace spricka::life {

NewmanClosure::NewmanClosure(double alpha, double stress_ratio) {
  const double stress = std::cos(0.5 * std::numbers::pi * stress_ratio);
  A_[0] = (0.825 - 0.34 * alpha + 0.05 * alpha * alpha) * std::pow(stress, 1.0 / alpha);
  A_[1] = (0.415 - 0.071 * alpha) * stress_ratio;
  A_[3] = 2.0 * A_[0] + A_[1] - 1.0;
  A_[2] = 1.0 - A_[0] - A_[1] - A_[3];
}

double NewmanClosure::operator()(double R) const {
  if (R < 0.0) {
    return A_[0] + std::max(R, -2.0) * A_[1];
  }
  return std::max(R, A_[0] + R * (A_[1] + R * (A_[2] + R * A_[3])));
}

} // namespace spricka::life
