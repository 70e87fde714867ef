// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "contact/constraint.hpp"
#include "mesh/cut/cracked.hpp"

/// The two faces of a crack as a contact pair.
namespace spricka::contact {

/// Rows of a crack's faces against each other (crack.30): one for each pair of nodes that lie on
/// one another, along the mean normal of the edges that meet there, scaled by the area that a
/// uniform pressure gives to the node; with friction one along the face as well. The tip, which
/// both faces share, has none. The left face carries the multipliers. A half model's only face
/// meets its mirror image on the symmetry line: rows on its own nodes, none along the line. The
/// surface runs with its body on the left: from the mouth to the tip on a left face.
PairConstraints build_crack_face_constraints(const model::Model& model, const model::Mesh& mesh,
                                             const mesh::CrackFaceNodes& crack_faces,
                                             bool friction);

} // namespace spricka::contact
