// SPDX-License-Identifier: GPL-3.0-or-later
#include "life/root.hpp"

#include "life/gsl.hpp"

#include <cmath>
#include <memory>

#include <gsl/gsl_roots.h>

namespace spricka::life {

std::optional<double> root_of_increasing_function(const std::function<double(double)>& f,
                                                  double begin, double end) {
  // y / (1 + |y|) has f's root and is finite where f is not
  const auto bounded = [&](double x) {
    const double y = f(x);
    return std::isinf(y) ? std::copysign(1.0, y) : y / (1.0 + std::fabs(y));
  };
  const double first = bounded(begin);
  const double last = bounded(end);
  if (!(first <= 0.0 && last >= 0.0)) {
    return std::nullopt;
  }
  if (first == 0.0 || last == 0.0) {
    return first == 0.0 ? begin : end;
  }
  disable_gsl_error_handler();
  const std::unique_ptr<gsl_root_fsolver, GslDeleter<gsl_root_fsolver_free>> solver(
      gsl_root_fsolver_alloc(gsl_root_fsolver_brent));
  const GslFunction function(bounded);
  gsl_root_fsolver_set(solver.get(), const_cast<gsl_function*>(function.get()), begin, end);
  constexpr int most_steps = 200;
  constexpr double tolerance = 1e-15;
  for (int i = 0; i < most_steps; ++i) {
    if (gsl_root_fsolver_iterate(solver.get()) != GSL_SUCCESS) {
      return std::nullopt;
    }
    const double low = gsl_root_fsolver_x_lower(solver.get());
    const double high = gsl_root_fsolver_x_upper(solver.get());
    if (gsl_root_test_interval(low, high, tolerance, tolerance) == GSL_SUCCESS) {
      break;
    }
  }
  return gsl_root_fsolver_root(solver.get());
}

} // namespace spricka::life
