// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "analysis/bodies/condense_bodies.hpp"
#include "analysis/scene/scene.hpp"
#include "contact/slide_record.hpp"

#include <span>
#include <vector>

/// Rigid motions of bodies that only contact without friction holds.
namespace spricka::analysis {

/// Rigid motions [dim * node, n] that cost a body nothing but the opening of its contacts: supports
/// leave them free, and no bond and no friction acts on the body.
std::vector<const base::Matrix*>
unresisted_rigid_motions(const Discretisation& scene, const std::vector<SubstructuredBody>& bodies);

/// The combination of the points' relative motions, [motion], that closes best the gaps that no row
/// counts: least squares weighted by thrust. Of the independent motions those are left out that
/// would move the surfaces past each other by more than `largest_slide` [length] (root of the mean
/// square): along surfaces that are almost parallel to it a motion closes any gap, but far off.
base::Vector fit_gap_closing_motion(std::span<const contact::DisplacedContactPoint> points,
                                    double largest_slide);

} // namespace spricka::analysis
