// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "crack/tip_setting.hpp"
#include "model/mesh.hpp"

#include <array>
#include <map>
#include <vector>

/// What tractions between the faces of a crack add to its energy release rate and its K.
namespace spricka::crack {

/// The terms by which integrals over a domain miss the tip's value (crack.31, crack.32), for
/// tractions t on the faces, per unit thickness: of G, - integral q t1 u1,1 ds (normal tractions
/// act where the faces do not part, and the tangential ones have no other component), and of the
/// interaction with the near-tip fields of modes 1 and 2, - integral q t . v_m,1 ds.
std::array<double, 3> crack_face_term(const TipContext& tip, const VirtualExtensionField& field,
                                      const ForcesBetweenCrackFaces& crack_faces,
                                      const base::Vector& u);

/// The interaction terms as sums over nodal forces (crack.33), [mode - 1] by node: sum of weight .
/// force.
using CrackFaceWeights = std::map<base::NodeId, std::array<base::Vec2, 2>>;
/// Weights of the forces at nodes of `faces` in the interaction terms of modes 1 and 2. Nodes are
/// left out whose edges the extension does not move.
CrackFaceWeights crack_face_weights(const TipContext& tip, const VirtualExtensionField& field,
                                    const std::vector<model::Face>& faces);

} // namespace spricka::crack
