// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "fe/dependence.hpp"
#include "fe/tie_trouble.hpp"

namespace spricka::fe {

/// The ties of all entries of Model::mpcs on a mesh, in deck order. TRANSITION: a slave node takes
/// the displacement of the point of the master faces nearest to it, by their shape functions; where
/// it lies off that point (the other side of a faceted arc), it is carried along by the rotation of
/// the face's corners, so that rigid motions stay free. Constant stress passes exactly where each
/// side of the fine mesh lies on one master face; one that spans several is warned of. RIGID: all
/// nodes move as one rigid body with small rotations, given by up to three of its nodes.
std::vector<Tie> make_ties(const model::Model& model, const model::Mesh& mesh,
                           std::vector<TieFailure>& troubles);

} // namespace spricka::fe
