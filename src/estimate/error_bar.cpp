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

// What eta is multiplied by, measured by tests/stability/coverage.py on its calibration half
// (manual, error_bar.md).
struct ErrorBarFactors {
  double bar = 1.8;
  double best = 1.2;
};

ErrorBarFactors of_type(base::ElementType type) {
  return type == base::ElementType::quamc9 ? ErrorBarFactors{1.8, 1.15} : ErrorBarFactors{1.8, 1.2};
}

// The constants of a mesh: those of its element types, by their share of sum |eta_e|.
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

} // namespace

results::KErrorBar error_bar(const model::Mesh& mesh, double K, double size, const GoalError& error,
                             const ActiveSetKChange& change, bool coarse) {
  const Shares share = coarse ? when_coarse : Shares{};
  const ErrorBarFactors constants = bar_constants(mesh, error);
  results::KErrorBar bar;
  bar.eta = error.eta;
  bar.sum = error.sum;
  bar.of_element = error.of_element;
  bar.set_change = change.end;
  bar.floor = floor_share * size;
  bar.mesh = constants.bar * std::abs(error.eta);
  bar.edge = share.end * change.end + share.sharp * change.sharp;
  bar.best = K + constants.best * error.eta;
  // Parts below the floor are noise and may cancel as they like (estimate.12).
  const bool counts = share_of_sum * error.sum > bar.floor;
  bar.cancels = counts && std::abs(error.eta) < cancelled * error.sum;
  if (bar.cancels || coarse) {
    bar.mesh = std::max(bar.mesh, share_of_sum * error.sum);
  }
  return bar;
}

} // namespace spricka::estimate
