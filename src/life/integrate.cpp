// SPDX-License-Identifier: GPL-3.0-or-later
#include "life/integrate.hpp"

#include "life/gsl.hpp"

#include <memory>

#include <gsl/gsl_integration.h>

namespace spricka::life {

namespace {

constexpr std::size_t k_most_parts = 200;

} // namespace

Integral integrate(const std::function<double(double)>& f, double begin, double end,
                   double tolerance) {
  Integral found;
  if (begin == end) {
    return found;
  }
  disable_gsl_error_handler();
  const std::unique_ptr<gsl_integration_workspace, GslDeleter<gsl_integration_workspace_free>> work(
      gsl_integration_workspace_alloc(k_most_parts));
  const GslFunction function(f);
  // What it returns is not asked for: a tolerance that was not reached stands in the error, which
  // the caller takes with the value.
  gsl_integration_qag(function.get(), begin, end, 0.0, tolerance, k_most_parts, GSL_INTEG_GAUSS31,
                      work.get(), &found.value, &found.error);
  return found;
}

} // namespace spricka::life
