// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "geometry/circle_about_axis.hpp"
#include "model/mesh.hpp"

#include <array>
#include <functional>
#include <utility>
#include <vector>

/// Where flaws begin: edges of elements, and the faces beside them.
namespace spricka::deck {

/// A face of a set: corners, outward normal.
struct FlawFace {
  std::vector<base::Vec3> corners;
  base::Vec3 centre = base::Vec3::Zero();
  base::Vec3 normal = base::Vec3::Zero(); ///< unit; in the plane not set
};
FlawFace flaw_face(const model::Mesh& mesh, const model::Face& face);

/// An edge of elements, perhaps curved: one where two face sets meet, or a side in the plane.
struct FlawEdge {
  std::array<base::Vec3, 3> x; ///< its ends and its middle
  FlawFace second;             ///< the face of the second set beside it, or the side

  [[nodiscard]] base::Vec3 point(double r) const { // -1 .. 1
    return 0.5 * r * (r - 1.0) * x[0] + 0.5 * r * (r + 1.0) * x[1] + (1.0 - r * r) * x[2];
  }
  [[nodiscard]] base::Vec3 tangent(double r) const {
    return ((r - 0.5) * x[0] + (r + 0.5) * x[1] - 2.0 * r * x[2]).normalized();
  }
};

/// Edges where two face sets in space meet, as faces of the second run.
std::vector<FlawEdge> shared_edges(const model::Mesh& mesh, const model::FaceSet& first,
                                   const model::FaceSet& second);

/// Sides in the plane, the body on the left.
std::vector<FlawEdge> side_edges(const model::Mesh& mesh, const model::FaceSet& set);

/// Ends and middles.
std::vector<base::Vec3> points_of_edges(const std::vector<FlawEdge>& edges);

/// The point of some edges, one at least, where a function is least: an edge and its coordinate.
std::pair<const FlawEdge*, double>
find_least_point(const std::vector<FlawEdge>& edges,
                 const std::function<double(const base::Vec3&)>& cost);

/// The circle on which points in a plane lie, within 1 % of its radius; else of no radius.
geometry::CircleAboutAxis find_flaw_circle(const std::vector<base::Vec3>& points);

/// Size of the box round some points, across its corners.
double diagonal_of_box(const std::vector<base::Vec3>& points);

} // namespace spricka::deck
