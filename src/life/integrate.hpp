// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <functional>

namespace spricka::life {

/// Integral of f from `begin` to `end`, to `tolerance` of its value: adaptive Gauss-Kronrod
/// quadrature (Piessens et al. 1983, QAG).
double integrate(const std::function<double(double)>& f, double begin, double end,
                 double tolerance);

} // namespace spricka::life
