// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "analysis/scene/scene.hpp"
#include "base/diagnostics.hpp"

/// MPCs in processor TOPOLOGY.
namespace spricka::analysis {

/// Solves the ties of the deck for the freedoms that follow, which become dependent in scene.cls;
/// masters of external ones become external. Mistakes (a slave off its master faces, a node that a
/// crack has cut out) go to `diagnostics` at their card. Returns whether the ties are sound.
bool eliminate_ties(const model::Model& model, Discretisation& scene,
                    base::Diagnostics& diagnostics);

/// Makes a freedom external; a dependent one hands this on to its masters.
void make_freedom_external(std::size_t freedom, const fe::ConstraintTransformation& ties,
                           std::vector<model::FreedomRole>& cls);

/// Gives dependent freedoms their part of the prescribed displacements and finds ties that
/// contradict prescribed or suppressed freedoms. Returns whether there are none.
bool prescribe_dependent_freedoms(const model::Model& model, Discretisation& scene,
                                  base::Diagnostics& diagnostics);

} // namespace spricka::analysis
