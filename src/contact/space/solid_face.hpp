// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/vec.hpp"
#include "model/mesh.hpp"

#include <array>
#include <span>
#include <vector>

/// Sides of solid elements as contact sees them: curved faces of 3, 4, 6, 8 or 9 nodes, cut into
/// triangles between their nodes.
namespace spricka::contact {

using base::Vec2;
using base::Vec3;

/// One number for each node of a face.
using FaceValues = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, 9, 1>;
using NodePlaces = Eigen::Matrix<double, 3, Eigen::Dynamic, 0, 3, 9>;

struct SolidFace {
  model::Face face;
  base::ElementType shape = base::ElementType::trim3; ///< the plane element with its functions
  std::vector<base::NodeId> nodes;                    ///< corners first
  NodePlaces X;                                       ///< [3, node]
};

SolidFace make_solid_face(const model::Mesh& mesh, const model::Face& face);

/// Shape functions of a face at r.
FaceValues face_N(base::ElementType type, const Vec2& r);

/// A point of a face: its place, dx/dr, and dx/dr1 x dx/dr2, which leaves the body.
struct SolidFacePoint {
  Vec3 x = Vec3::Zero();
  Eigen::Matrix<double, 3, 2> slope = Eigen::Matrix<double, 3, 2>::Zero();
  [[nodiscard]] Vec3 area_vector() const;
};
SolidFacePoint point_on(const SolidFace& face, const Vec2& r);

/// Reference coordinates of a node of a face.
Vec2 node_local_coordinates(base::ElementType type, int node);
/// The middle of a face.
Vec2 centre_local_coordinates(base::ElementType type);
/// How far r lies outside a face, in units of its reference coordinates; negative inside.
double distance_outside(base::ElementType type, const Vec2& r);
/// Area of the curved face.
double face_area(const SolidFace& face);

/// Three nodes of a face, round the way the face's corners go.
using FaceTriangle = std::array<int, 3>;
/// A face cut into triangles: TRIM3 1, QUAM4 2, TRIMC6 4, QUAMC8 6, QUAMC9 8. Each node is a
/// corner of some, so that hats on them are one function for each node.
std::span<const FaceTriangle> face_triangles(base::ElementType type);
/// The same between the corners of the face only: 1 or 2.
std::span<const FaceTriangle> face_corner_triangles(base::ElementType type);

} // namespace spricka::contact
