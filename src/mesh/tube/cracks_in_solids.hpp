// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "mesh/tube/solid_crack.hpp"
#include "model/forward.hpp"

#include <vector>

namespace spricka::model {
struct CrackDefinition;
}

namespace spricka::mesh {

/// The cracks of a deck in space, ready to be cut. [crack]
std::vector<SolidCrack> make_solid_cracks(const model::Model& model);

/// Parametric angle of a place on the front of an ellipse, from its axis C [rad], -pi .. pi.
double ellipse_parametric_angle(const model::CrackDefinition& crack, const base::Vec3& x);

} // namespace spricka::mesh
