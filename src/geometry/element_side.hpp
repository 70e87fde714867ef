// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/id.hpp"
#include "base/vec.hpp"
#include "geometry/box.hpp"
#include "shape/quadrature.hpp"
#include "shape/reference_element.hpp"

#include <Eigen/Geometry>

#include <array>
#include <span>
#include <vector>

/// The side of an element: an edge of a plane element, a face of a solid.
namespace spricka::geometry {

/// One number for each node of a side. [node]
using SideValues = shape::ReferenceElement<2>::Values;
/// Derivatives with respect to both local coordinates. [node, 2]
using SideDerivatives = shape::ReferenceElement<2>::ShapeDerivatives;
/// Positions of the nodes. [3, node]
using SidePositions = Eigen::Matrix<double, 3, Eigen::Dynamic, 0, 3, shape::most_nodes<2>>;
/// dx/dr, a column for each local coordinate.
using SideTangents = Eigen::Matrix<double, 3, 2>;

/// A point of a side.
struct SidePoint {
  base::Vec3 x = base::Vec3::Zero();
  SideTangents tangents = SideTangents::Zero();

  /// Normal out of the body times the area for a unit of the local coordinates; of an edge the
  /// length, which is the area of a body of unit thickness.
  [[nodiscard]] base::Vec3 area_vector() const { return tangents.col(0).cross(tangents.col(1)); }
  /// Unit normal out of the body; zero where the side has no area.
  [[nodiscard]] base::Vec3 normal() const { return area_vector().normalized(); }
};

/// What nearest_point does with a foot of the perpendicular that was kept from leaving a face.
enum class ClampedFootPolicy {
  compared, ///< gives way to a foot on an edge that is nearer
  replaced  ///< always gives way; feet on edges are sought however far x is off
};

/// A straight or curved side: 2 or 3 nodes (edges), 3, 4, 6, 8 or 9 (faces). Its local coordinates
/// r have two places; an edge uses the first, and the second is zero. Edges run with the body on
/// their left in the plane z = 0, nodes of faces round the outer normal.
struct ElementSide {
  base::ElementId element;
  int side = 0;                    ///< of the element
  std::vector<base::NodeId> nodes; ///< corners first, then mid nodes, then the centre
  SidePositions X;

  /// Side `side` of an element of a type; its nodes are the numbers `element_nodes` into x, the
  /// positions of all nodes.
  ElementSide(base::ElementType type, int side, std::span<const base::NodeId> element_nodes,
              std::span<const base::Vec3> x);

  /// An edge of a plane element, not a face of a solid.
  [[nodiscard]] bool is_edge() const { return edge_ != nullptr; }
  [[nodiscard]] int local_dim() const { return is_edge() ? 1 : 2; }
  [[nodiscard]] int corner_count() const { return is_edge() ? 2 : face_->corners; }
  [[nodiscard]] bool is_quadratic() const {
    return is_edge() ? edge_->quadratic : face_->quadratic;
  }
  /// What the local coordinates run over.
  [[nodiscard]] shape::ReferenceDomain domain() const {
    return is_edge() ? edge_->domain : face_->domain;
  }
  /// The shape with points of d coordinates; d must be local_dim().
  template <int d> [[nodiscard]] const shape::ReferenceElement<d>& reference_element() const {
    if constexpr (d == 1) {
      return *edge_;
    } else {
      return *face_;
    }
  }

  /// Local coordinates of a node; the second of an edge's is 0.
  [[nodiscard]] base::Vec2 node_local_coordinates(int node) const;
  /// The middle of the domain.
  [[nodiscard]] base::Vec2 domain_centre() const;
  /// How far r lies outside the domain, in local coordinates; negative inside.
  [[nodiscard]] double distance_outside(const base::Vec2& r) const;
  /// r moved into the domain: to its nearest point, but beside the slanted edge of triangles
  /// straight back to that edge, then along it.
  [[nodiscard]] base::Vec2 clamp_to_side(const base::Vec2& r) const;
  /// Local coordinates at t [-1,1] on the edge of a face from corner i to the next.
  [[nodiscard]] base::Vec2 edge_coordinates(int i, double t) const;

  /// Shape functions at local coordinates, one for each node of the side.
  [[nodiscard]] SideValues N(const base::Vec2& r) const;
  /// Derivatives of the shape functions by the local coordinates; by the second one of an edge
  /// zero.
  [[nodiscard]] SideDerivatives dN(const base::Vec2& r) const;

  /// The point of the side at local coordinates.
  [[nodiscard]] base::Vec3 position(const base::Vec2& r) const { return X * N(r); }
  /// dx/dr; of an edge the second is the normal of the plane.
  [[nodiscard]] SideTangents tangents(const base::Vec2& r) const;
  /// Position and tangents of the side at local coordinates.
  [[nodiscard]] SidePoint point(const base::Vec2& r) const { return {position(r), tangents(r)}; }
  /// Normal of the side at local coordinates, as long as the area of a unit of them (SidePoint).
  [[nodiscard]] base::Vec3 area_vector(const base::Vec2& r) const {
    return SidePoint{base::Vec3::Zero(), tangents(r)}.area_vector();
  }

  /// Calls f(r, weight) for the points of the rule of some degree (shape/quadrature.hpp).
  template <class F> void for_quadrature_points(int degree, F&& f) const {
    if (is_edge()) {
      for (const auto& point : shape::line_rule(degree)) {
        f(base::Vec2(point.r[0], 0.0), point.weight);
      }
    } else {
      for (const auto& point : shape::quadrature<2>(face_->domain, degree)) {
        f(point.r, point.weight);
      }
    }
  }
  /// Area of the curved face, length of the curved edge, by the rule of some degree.
  [[nodiscard]] double area(int degree = 7) const;

  /// Local coordinates of the point nearest to x, by Gauss and Newton's method: the foot of the
  /// perpendicular, or the nearest point of the edges. Exact for points on the side and for those
  /// off it by a small share of the radius of curvature. Without area the centre.
  [[nodiscard]] base::Vec2
  nearest_local_coordinates(const base::Vec3& x,
                            ClampedFootPolicy border = ClampedFootPolicy::compared) const;

  /// A box round the side, curved as it may be: that of its Bezier points (Farin 2002).
  [[nodiscard]] Box<3> bounding_box() const;

private:
  // One of both: the other is null.
  const shape::ReferenceElement<1>* edge_ = nullptr;
  const shape::ReferenceElement<2>* face_ = nullptr;
};

/// Mesh nodes of side `side` of an element, corners first.
std::vector<base::NodeId> side_nodes(base::ElementType type, int side,
                                     std::span<const base::NodeId> element_nodes);

/// Calls f(reference element, X) for what is compiled for each dimension; f is a generic lambda
/// `[&]<int dim>(const shape::ReferenceElement<dim>& side, const SidePositions& X)`.
template <class F> void with_reference_element(const ElementSide& side, F&& f) {
  if (side.is_edge()) {
    f(side.reference_element<1>(), side.X);
  } else {
    f(side.reference_element<2>(), side.X);
  }
}

} // namespace spricka::geometry
