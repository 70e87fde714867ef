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
constexpr double cancelled = 0.2; // |eta| below this share of the sum says little

// Shares of a bar's parts, measured by tests/stability/coverage.py on its calibration half (manual,
// error_bar.md).
struct ErrorBarShares {
  double eta = 1.8;
  double sum = 0.4;    ///< of that of the elements' parts without signs, where they cancel
  double floor = 1e-4; ///< of hypot(K1, K2)
  double edge = 1.0;   ///< of the shares of changes of the active set
};
constexpr ErrorBarShares of_raw_K{};
constexpr ErrorBarShares of_best_K{.eta = 0.6, .sum = 0.15, .floor = 5e-5, .edge = 2.0 / 3.0};

// What eta is multiplied by to be taken out, measured alike.
constexpr double usual_factor = 1.2;
double factor_of_type(base::ElementType type) {
  return type == base::ElementType::quamc9 ? 1.15 : usual_factor;
}

// That of a mesh: of its element types, by their shares of sum |eta_e| (estimate.11).
double correction_factor(const model::Mesh& mesh, const GoalError& error) {
  double mean = 0.0;
  double total = 0.0;
  for (std::size_t e = 0; e < mesh.element_count(); ++e) {
    const double weight = std::abs(error.of_element[e]);
    mean += weight * factor_of_type(mesh.type[e]);
    total += weight;
  }
  return total > 0.0 ? mean / total : usual_factor;
}

} // namespace

results::KErrorBar error_bar(const model::Mesh& mesh, double K, double size, const GoalError& error,
                             const ActiveSetKChange& change, const ErrorBarUse& use) {
  const Shares share = use.coarse ? when_coarse : Shares{};
  const double taken_out = correction_factor(mesh, error) * error.eta;
  results::KErrorBar bar;
  bar.of_best = use.corrected && !use.coarse && std::abs(taken_out) <= largest_correction * size;
  // How far faces are closed, which K of such a crack hangs on, is what no estimate sees.
  const ErrorBarShares& shares = bar.of_best && !use.closes ? of_best_K : of_raw_K;
  bar.eta = error.eta;
  bar.sum = error.sum;
  bar.of_element = error.of_element;
  bar.set_change = change.end;
  bar.floor = shares.floor * size;
  bar.mesh = shares.eta * std::abs(error.eta);
  bar.edge = shares.edge * (share.end * change.end + share.sharp * change.sharp);
  bar.best = K + taken_out;
  // Parts below the floor are noise and may cancel as they like (estimate.12).
  const bool counts = shares.sum * error.sum > bar.floor;
  bar.cancels = counts && std::abs(error.eta) < cancelled * error.sum;
  if (bar.cancels || use.coarse) {
    bar.mesh = std::max(bar.mesh, shares.sum * error.sum);
  }
  return bar;
}

} // namespace spricka::estimate
