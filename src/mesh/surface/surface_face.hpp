// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/element_type.hpp"
#include "base/vec.hpp"
#include "model/mesh.hpp"

#include <array>
#include <vector>

namespace spricka::mesh {

/// A side of a solid as a curved face of 3, 4, 6, 8 or 9 nodes.
struct CurvedFace {
  model::Face face;
  base::ElementType shape = base::ElementType::trim3;  ///< the plane element with its functions
  std::vector<base::NodeId> nodes;                     ///< corners first, round the outer normal
  Eigen::Matrix<double, 3, Eigen::Dynamic, 0, 3, 9> X; ///< [3, node]

  [[nodiscard]] int corners() const { return base::element_info(shape).corners; }
  [[nodiscard]] bool quadratic() const { return base::element_info(shape).quadratic; }
};

CurvedFace make_surface_face(const model::Mesh& mesh, const model::Face& face);

/// A point of a face: where it is, and dx/dr.
struct CurvedFacePoint {
  base::Vec3 x = base::Vec3::Zero();
  Eigen::Matrix<double, 3, 2> slope = Eigen::Matrix<double, 3, 2>::Zero();

  [[nodiscard]] base::Vec3 normal() const; ///< unit, out of the body; zero where the face has none
};
CurvedFacePoint point_on(const CurvedFace& face, const base::Vec2& r);

/// Reference coordinates at t [-1,1] on the edge from corner i to the next.
base::Vec2 edge_coordinates(base::ElementType shape, int i, double t);
/// How far r lies outside the face, in reference coordinates; negative inside.
double distance_outside(base::ElementType shape, const base::Vec2& r);
/// The nearest r of the face.
base::Vec2 clamp_to_face(base::ElementType shape, const base::Vec2& r);

/// Reference coordinates of the point of a face nearest to x.
base::Vec2 nearest_on(const CurvedFace& face, const base::Vec3& x);

/// Corners of the box round a face, curved as it may be.
std::array<base::Vec3, 2> bounding_box(const CurvedFace& face);

} // namespace spricka::mesh
