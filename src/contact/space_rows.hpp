// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "contact/constraint.hpp"
#include "contact/space/surface_projection.hpp"

#include <cstddef>
#include <functional>
#include <map>
#include <optional>
#include <vector>

namespace spricka::contact {

/// [node of a crack's front] the node behind it.
using NodesBehind = std::map<base::NodeId, base::NodeId>;

/// Fills the rows of a pair of solid surfaces (contact_space.5): the pressure is a sum of
/// hats on the triangles between all nodes of the faces, gaps are weighted by the functions dual to
/// these (Wohlmuth 2000) on what the target covers of each triangle (Popp et al. 2013), so that
/// each weight is positive on any face type and any part of a face. A node covered by less than a
/// fifth joins a neighbour. `tangents`: two rows along the surface for each normal one.
/// Functions of nodes at a crack's front, where the faces cannot part, go to the nodes behind it.
void fill_space_mortar_rows(PairConstraints& pair, std::optional<double> declared_gap,
                            bool tangents, const NodesBehind& at_front = {});

/// What the triangles of a pair's contact surface see of its target, which may be rigid. The pair
/// must outlive it.
std::function<ProjectedTriangle(const SurfaceTriangle&)>
target_projector(const PairConstraints& pair);

/// Places among the pair's functions of the nodes of each face of its contact surface, or of its
/// corners where only these have functions.
std::vector<std::vector<std::size_t>> functions_by_face(const PairConstraints& pair);

} // namespace spricka::contact
