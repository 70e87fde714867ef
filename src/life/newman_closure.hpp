// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <array>

namespace spricka::life {

/// Newman's crack opening function K_op / K_max at the stress ratio R (Newman 1984; life.7).
class NewmanClosure {
public:
  NewmanClosure(double alpha, double stress_ratio);
  [[nodiscard]] double operator()(double R) const;

private:
  std::array<double, 4> A_;
};

} // namespace spricka::life
