// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/id.hpp"
#include "base/vec.hpp"
#include "model/mesh.hpp"

#include <span>
#include <vector>

#include <Eigen/Geometry>

namespace spricka::fe {

/// A place inside an element: reference coordinates r, and how far the point that was looked for
/// lies outside the element in them; 0 inside.
struct ElementHit {
  base::ElementId element;
  base::Vec3 r = base::Vec3::Zero();
  double outside = 0.0;
};

/// Elements that hold a point, in mesh order. A point of the true boundary that lies off the mesh
/// by less than 5 % of an element (the sagitta of an arc) belongs to the elements next to it.
std::vector<ElementHit> elements_at_point(const model::Mesh& mesh, const base::Vec3& point);

/// Some elements with the boxes that hold them, for many points.
class ElementBoxes {
public:
  /// The mesh must outlive it.
  ElementBoxes(const model::Mesh& mesh, std::span<const base::ElementId> elements);

  /// elements_at_point() among these.
  [[nodiscard]] std::vector<ElementHit> elements_at(const base::Vec3& point) const;

private:
  struct ElementBox {
    base::ElementId element;
    Eigen::AlignedBox3d around;
  };
  const model::Mesh& mesh_;
  std::vector<ElementBox> boxes_;
};

/// Elements at a point that hang together there. Where faces of a crack or two bodies meet there
/// are several, in mesh order of their first elements.
using PointElementGroup = std::vector<ElementHit>;
/// Groups the elements at a point into sides, joined by common nodes. Elements that only come near
/// the point are dropped where another one holds it.
std::vector<PointElementGroup> group_elements_at_point(const model::Mesh& mesh,
                                                       const std::vector<ElementHit>& hits);

/// Whether two elements have a node in common.
bool have_common_node(const model::Mesh& mesh, base::ElementId a, base::ElementId b);

/// Displacement [3] on one side of a point, of the nodal vector u [dim * node].
base::Vec3 displacement_at(const model::Mesh& mesh, const base::Vector& u,
                           const PointElementGroup& side);

} // namespace spricka::fe
