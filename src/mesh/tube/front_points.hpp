// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "mesh/cut/cracked.hpp"
#include "mesh/tube/solid_crack.hpp"

/// Points of a front in space: where they are and how much of it they stand for.
namespace spricka::mesh {

/// Weights of the points of a front: the lengths below their linear hats, from their s.
void compute_front_point_weights(bool closed, CrackFront& front);

/// The front as smooth as its elements have it: the spline through its points, near the ends of an
/// open one through those that lie half a radius of the tube or more apart. What is shorter than
/// that in a front as it was drawn or grown, elements round it do not follow, and the axes along it
/// would waver from it all over the domains.
std::shared_ptr<const FrontCurve> fit_front_curve(const CrackFront& front, const SolidCrack& crack);

/// Places, growth directions, s and weights of points whose nodes or curve have been moved.
void update_front_points(const model::Mesh& mesh, CrackFront& front);

} // namespace spricka::mesh
