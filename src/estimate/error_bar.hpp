// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "estimate/goal_error.hpp"
#include "results/k_bar.hpp"

namespace spricka::estimate {

/// Part of the largest change of the active set that a bar takes, read off cracks that a residual
/// field closes along a part (manual, error_bar.md); the rest of its edge is that of sharp edges.
constexpr double share_of_set_change = 0.15;

/// Errors that are estimated larger than this part of the largest K are not taken out of it: meshes
/// that coarse are none that the shares of bars were measured on.
constexpr double largest_correction = 0.25;

/// By how much one K changes when a contact pair changes its state.
struct ActiveSetKChange {
  double end = 0.0;   ///< the largest, of pairs beside the end of a contact
  double sharp = 0.0; ///< sum over those at sharp edges, where pressure has no bound
};
/// How an estimated error is used.
struct ErrorBarUse {
  bool coarse = false;    ///< a contact is too coarse for eta to be trusted
  bool corrected = false; ///< K counts with its estimated error taken out, unless it is coarse
  bool closes = false;    ///< faces of the crack bear on one another: the bar of raw K is kept
};
/// The bar of K1 or K2 of a tip (manual, estimate.11 and 12) from its estimated error and changes
/// of the active set. `K`: as the mesh has it. `size`: hypot(K1, K2), of which the floor is a part,
/// below which signs of eta are noise.
results::KErrorBar error_bar(const model::Mesh& mesh, double K, double size, const GoalError& error,
                             const ActiveSetKChange& change, const ErrorBarUse& use);

} // namespace spricka::estimate
