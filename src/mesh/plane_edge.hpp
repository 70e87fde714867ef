// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/vec.hpp"
#include "model/mesh.hpp"

#include <array>

/// A straight or quadratic edge of a plane element with its shape functions.
namespace spricka::mesh {

/// One edge, run with the body on its left; xi = -1 at nodes[0], +1 at nodes[1], mid node last.
struct PlaneEdge {
  std::array<base::NodeId, 3> nodes;
  int count = 2; ///< 2 straight, 3 quadratic
  std::array<base::Vec2, 3> x;
  double length = 0.0; ///< of the curve, by three Gauss points
};

/// The edge of a plane element at a side, with nodes, coordinates and length.
PlaneEdge plane_edge(const model::Mesh& mesh, const model::Face& face);

/// Values of the shape functions of an edge at xi; entry 2 is zero for straight edges.
std::array<double, 3> edge_shape_functions(const PlaneEdge& edge, double xi);

/// The place on an edge at xi, from -1 to 1.
base::Vec2 point_on_edge(const PlaneEdge& edge, double xi);
/// Tangent of an edge at xi in the direction in which it runs, not of unit length.
base::Vec2 edge_tangent(const PlaneEdge& edge, double xi); ///< dx/dxi
/// Unit normal that leaves the body.
base::Vec2 outer_normal(const PlaneEdge& edge, double xi);

} // namespace spricka::mesh
