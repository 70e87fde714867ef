// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "analysis/scene/scene.hpp"
#include "contact/sliding_motions.hpp"

#include <vector>

namespace spricka::analysis {

/// Contacts that press, with the points of their surfaces: not bonded ones, not those between the
/// faces of a crack, which belong to one body. Nodes that follow others are left out.
std::vector<contact::ContactRowSurfaces> pressing_contact_surfaces(const Discretisation& scene);

} // namespace spricka::analysis
