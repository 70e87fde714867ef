// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/vec.hpp"

#include <array>
#include <vector>

/// Triangles in a plane and what they have in common.
namespace spricka::contact {

using PlaneTriangle = std::array<base::Vec2, 3>;

/// Twice the area, positive where the corners run counter-clockwise.
double twice_area(const PlaneTriangle& t);

/// What two counter-clockwise triangles have in common: a convex polygon of at most six corners,
/// counter-clockwise, empty where they do not overlap (Sutherland and Hodgman 1974).
std::vector<base::Vec2> intersect_triangles(const PlaneTriangle& a, const PlaneTriangle& b);

/// Barycentric coordinates of x.
Eigen::Vector3d barycentric_coordinates(const PlaneTriangle& t, const base::Vec2& x);

} // namespace spricka::contact
