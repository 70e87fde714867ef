// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "estimate/goal_error.hpp"

#include <array>

namespace spricka::estimate {

/// K1 and K2 of one tip with their error bars (manual, estimate.11 and 12).
struct ErrorBar {
  double mesh = 0.0;    ///< from the modes [stress intensity]
  double edge = 0.0;    ///< from where contact ends, and from edges that it is closed up to
  double floor = 0.0;   ///< below this signs of eta are noise
  double best = 0.0;    ///< K with its estimated error taken out
  bool cancels = false; ///< the parts of eta cancel: its size says little

  [[nodiscard]] double size() const { return mesh + edge + floor; }
};

/// What eta is multiplied by, found by comparison with known values (manual, error_bar.md).
struct ErrorBarFactors {
  double bar = 1.8;
  double best = 1.2;
};
/// The constants of a mesh: those of its element types, by their share of sum |eta_e|.
ErrorBarFactors bar_constants(const model::Mesh& mesh, const GoalError& error);

/// Part of the largest change of the active set that a bar takes, read off cracks that a residual
/// field closes along a part (manual, error_bar.md); the rest of its edge is that of sharp edges.
constexpr double share_of_set_change = 0.15;

/// Changes of one K when a contact pair changes its state.
struct ActiveSetChange {
  double end = 0.0;   ///< the largest, of pairs beside the end of a contact
  double sharp = 0.0; ///< sum over those at sharp edges, where pressure has no bound
};
/// K, errors and changes of the active set by mode. `coarse`: a contact is too coarse for eta to be
/// trusted.
std::array<ErrorBar, 2> error_bars(const model::Mesh& mesh, const std::array<double, 2>& K,
                                   const std::array<const GoalError*, 2>& errors,
                                   const std::array<ActiveSetChange, 2>& set_change, bool coarse);

} // namespace spricka::estimate
