// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/space/solid_face.hpp"

#include "shape/quadrature.hpp"
#include "shape/reference_element.hpp"
#include "shape/topology.hpp"

#include <Eigen/Geometry>

namespace spricka::contact {

using base::ElementType;

namespace {

constexpr std::array<FaceTriangle, 1> corners_of_triangle{{{0, 1, 2}}};
// Along the diagonal from the first corner, as neither of the two is preferred.
constexpr std::array<FaceTriangle, 2> corners_of_quadrilateral{{{0, 1, 2}, {0, 2, 3}}};
constexpr std::array<FaceTriangle, 4> triangles_of_6{{{0, 3, 5}, {3, 1, 4}, {5, 4, 2}, {3, 4, 5}}};
constexpr std::array<FaceTriangle, 6> triangles_of_8{
    {{0, 4, 7}, {4, 1, 5}, {5, 2, 6}, {6, 3, 7}, {4, 5, 6}, {4, 6, 7}}};
constexpr std::array<FaceTriangle, 8> triangles_of_9{
    {{0, 4, 8}, {4, 1, 8}, {1, 5, 8}, {5, 2, 8}, {2, 6, 8}, {6, 3, 8}, {3, 7, 8}, {7, 0, 8}}};

constexpr int area_degree = 7;

} // namespace

SolidFace make_solid_face(const model::Mesh& mesh, const model::Face& face) {
  const ElementType type = mesh.type[face.element.index()];
  const std::span<const base::NodeId> nodes = mesh.element_nodes(face.element);
  SolidFace out{face, shape::solid_side_type(type, face.side), {}, {}};
  for (const int local : shape::side_nodes(type, face.side)) {
    out.nodes.push_back(nodes[static_cast<std::size_t>(local)]);
  }
  out.X.resize(3, static_cast<Eigen::Index>(out.nodes.size()));
  for (std::size_t i = 0; i < out.nodes.size(); ++i) {
    out.X.col(static_cast<Eigen::Index>(i)) = mesh.x[out.nodes[i].index()];
  }
  return out;
}

FaceValues face_N(ElementType type, const Vec2& r) {
  return shape::reference_element<2>(type).N(r);
}

Vec3 SolidFacePoint::area_vector() const {
  return slope.col(0).cross(slope.col(1));
}

SolidFacePoint point_on(const SolidFace& face, const Vec2& r) {
  const shape::ReferenceElement<2>& element = shape::reference_element<2>(face.shape);
  return {face.X * element.N(r), face.X.lazyProduct(element.dN(r))};
}

Vec2 node_local_coordinates(ElementType type, int node) {
  return shape::reference_element<2>(type).node_coordinates(node);
}

Vec2 centre_local_coordinates(ElementType type) {
  return shape::reference_element<2>(type).centre();
}

double distance_outside(ElementType type, const Vec2& r) {
  return shape::reference_element<2>(type).distance_outside(r);
}

double face_area(const SolidFace& face) {
  const shape::ReferenceDomain domain = shape::reference_element<2>(face.shape).domain;
  double area = 0.0;
  for (const auto& [r, weight] : shape::quadrature<2>(domain, area_degree)) {
    area += weight * point_on(face, r).area_vector().norm();
  }
  return area;
}

std::span<const FaceTriangle> face_triangles(ElementType type) {
  switch (type) {
  case ElementType::trimc6:
    return triangles_of_6;
  case ElementType::quamc8:
    return triangles_of_8;
  case ElementType::quamc9:
    return triangles_of_9;
  default:
    return face_corner_triangles(type);
  }
}

std::span<const FaceTriangle> face_corner_triangles(ElementType type) {
  if (base::element_info(type).corners == 3) {
    return corners_of_triangle;
  }
  return corners_of_quadrilateral;
}

} // namespace spricka::contact
