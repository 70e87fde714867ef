// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "mesh/cut/cracked.hpp"

/// Points of a front in space: where they are and how much of it they stand for.
namespace spricka::mesh {

/// Weights of the points of a front: the lengths below their linear hats, from their s.
void weigh_points(bool closed, Front& front);

/// Places, growth directions, s and weights of points whose nodes or curve have been moved.
void place_points(const model::Mesh& mesh, Front& front);

} // namespace spricka::mesh
