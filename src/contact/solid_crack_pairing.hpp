// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "contact/constraint.hpp"
#include "mesh/cut/cracked.hpp"

/// The two faces of a crack in space as a contact pair.
namespace spricka::contact {

/// Rows of a crack's faces against each other (crack_space.18): those of (contact_space.5) between
/// faces that lie on one another node by node, the upper one with the pressure. A node of the
/// front, where the faces cannot part, gives its function to the node behind it, across the first
/// elements; with friction there are two rows along the faces for each normal one. `trouble` where
/// the faces are no twins.
PairConstraints build_solid_crack_constraints(const model::Model& model, const model::Mesh& mesh,
                                              const mesh::CrackFaceNodes& crack_faces,
                                              bool friction);

} // namespace spricka::contact
