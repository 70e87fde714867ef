// SPDX-License-Identifier: GPL-3.0-or-later
#include "estimate/error_bar.hpp"

#include <algorithm>
#include <cmath>

namespace spricka::estimate {

namespace {

// Parts of changes of the active set. What a sharp edge presses on its last half element is the
// less known the larger that is.
struct Shares {
  double end = share_of_set_change;
  double sharp = 0.1;
};
constexpr Shares when_coarse{0.25, 0.6};
constexpr double floor_share = 1e-4; // of hypot(K1, K2)
constexpr double cancelled = 0.2;    // |eta| below this share of the sum says little
constexpr double share_of_sum = 0.4;

// Measured by tests/stability/coverage.py on its calibration half (manual, error_bar.md).
ErrorBarFactors of_type(base::ElementType type) {
  return type == base::ElementType::quamc9 ? ErrorBarFactors{1.8, 1.15} : ErrorBarFactors{1.8, 1.2};
}

} // namespace

ErrorBarFactors bar_constants(const model::Mesh& mesh, const GoalError& error) {
  ErrorBarFactors mean{0.0, 0.0};
  double total = 0.0;
  for (std::size_t e = 0; e < mesh.element_count(); ++e) {
    const ErrorBarFactors own = of_type(mesh.type[e]);
    const double weight = std::abs(error.of_element[e]);
    // Mixed by the types' shares of sum |eta_e| (estimate.11).
    mean.bar += weight * own.bar;
    mean.best += weight * own.best;
    total += weight;
  }
  if (!(total > 0.0)) {
    return {};
  }
  return {mean.bar / total, mean.best / total};
}

std::array<ErrorBar, 2> error_bars(const model::Mesh& mesh, const std::array<double, 2>& K,
                                   const std::array<const GoalError*, 2>& errors,
                                   const std::array<ActiveSetChange, 2>& set_change, bool coarse) {
  std::array<ErrorBar, 2> bars;
  const double size = std::hypot(K[0], K[1]);
  const Shares share = coarse ? when_coarse : Shares{};
  for (std::size_t k = 0; k < 2; ++k) {
    const GoalError& error = *errors[k];
    const ErrorBarFactors constants = bar_constants(mesh, error);
    ErrorBar& bar = bars[k];
    bar.floor = floor_share * size;
    bar.mesh = constants.bar * std::abs(error.eta);
    bar.edge = share.end * set_change[k].end + share.sharp * set_change[k].sharp;
    bar.best = K[k] + constants.best * error.eta;
    // Parts below the floor are noise and may cancel as they like (estimate.12).
    const bool counts = share_of_sum * error.sum > bar.floor;
    bar.cancels = counts && std::abs(error.eta) < cancelled * error.sum;
    if (bar.cancels || coarse) {
      bar.mesh = std::max(bar.mesh, share_of_sum * error.sum);
    }
  }
  return bars;
}

} // namespace spricka::estimate
