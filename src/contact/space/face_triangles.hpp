// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/vec.hpp"
#include "geometry/element_side.hpp"

#include <array>
#include <span>

/// Faces of solids as contact sees them: cut into triangles between their nodes.
namespace spricka::contact {

using base::Vec2;
using base::Vec3;

/// Three nodes of a face, round the way the face's corners go.
using FaceTriangle = std::array<int, 3>;
/// A face cut into triangles, by its number of nodes: 3 1, 4 2, 6 4, 8 6, 9 8. Each node is a
/// corner of some, so that hats on them are one function for each node.
std::span<const FaceTriangle> face_triangles(const geometry::ElementSide& face);
/// The same between the corners of the face only: 1 or 2.
std::span<const FaceTriangle> face_corner_triangles(const geometry::ElementSide& face);

/// Local coordinates of three nodes of a face.
std::array<Vec2, 3> corner_coordinates(const geometry::ElementSide& face,
                                       const FaceTriangle& nodes);

} // namespace spricka::contact
