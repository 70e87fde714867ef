// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <functional>

namespace spricka::life {

struct Integral {
  double value = 0.0;
  double error = 0.0; ///< estimate of what the value may be off by, in the value's unit
};

/// Integral of f from `begin` to `end`, to `tolerance` of its value where 200 parts are enough for
/// that: adaptive Gauss-Kronrod quadrature (Piessens et al. 1983, QAG).
Integral integrate(const std::function<double(double)>& f, double begin, double end,
                   double tolerance);

} // namespace spricka::life
