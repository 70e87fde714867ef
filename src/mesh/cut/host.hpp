// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "geometry/box_tree.hpp"
#include "mesh/cut/crack_frame.hpp"
#include "mesh/node_elements.hpp"
#include "model/mesh.hpp"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

namespace spricka::mesh {

/// An edge of a 2D element: the nodes at its ends, body on the left, and in the middle (invalid for
/// linear elements).
struct EdgeEndAndMidNodes {
  base::NodeId a, b, mid;
};
EdgeEndAndMidNodes element_edge_nodes(const model::Mesh& mesh, const model::Face& face);

/// Point of an edge at xi in [-1, 1] on its own, straight or quadratic, curve.
base::Vec3 point_on_edge(const model::Mesh& mesh, const EdgeEndAndMidNodes& edge, double xi);

/// The same, of an edge with a middle node, in a crack's frame: from rounded coordinates.
base::Vec2 point_on_edge(const model::Mesh& mesh, const CrackFrame& frame,
                         const EdgeEndAndMidNodes& edge, double xi);

/// The point of an edge nearest to p.
struct NearestEdgePoint {
  double xi = 0.0;
  double distance = 0.0;
};
NearestEdgePoint nearest_point_on_edge(const model::Mesh& mesh, const EdgeEndAndMidNodes& edge,
                                       const base::Vec3& p);

/// Whether an edge is for certain farther from p than `distance`: a quick test.
bool is_edge_beyond_distance_of_point(const model::Mesh& mesh, const EdgeEndAndMidNodes& edge,
                                      const base::Vec3& p, double distance);

/// Corner and mid nodes of an element in the crack's frame, in order round it.
std::vector<base::Vec2> element_polygon_in_frame(const model::Mesh& mesh, base::ElementId e,
                                                 const CrackFrame& frame);

/// Finds of some elements the one that a point of the crack's frame lies in, or comes nearest to.
class ElementOutlines {
public:
  ElementOutlines(const model::Mesh& mesh, std::span<const base::ElementId> elements,
                  const CrackFrame& frame);

  /// The place of that element among them, of several the first.
  [[nodiscard]] std::size_t nearest_element_index(const base::Vec2& p) const;

private:
  std::vector<std::vector<base::Vec2>> outlines_; ///< [element]
  geometry::BoxTree<2> boxes_;                    ///< [element]
};

/// Whether the element of a face belongs to a net (any net: invalid).
bool is_face_element_in_net(const model::Mesh& mesh, const model::Face& face, base::NetId net);

/// A mesh, plane or solid, with its neighbourhoods. Functions that want one take a mesh as well;
/// who calls several makes it once.
class HostMesh {
public:
  HostMesh(const model::Mesh& mesh);

  [[nodiscard]] const model::Mesh& mesh() const { return mesh_; }
  /// Elements that have this node, ascending.
  [[nodiscard]] std::span<const base::ElementId> elements_around(base::NodeId node) const {
    return elements_.elements_around(node);
  }
  /// The element on the other side of an element's side, of several the first; empty on the
  /// boundary.
  [[nodiscard]] std::optional<base::ElementId> neighbour(const model::Face& face) const {
    const std::int32_t e = beyond_[place(face)];
    return e < 0 ? std::nullopt : std::optional(base::ElementId(static_cast<std::size_t>(e)));
  }
  /// Sides of one element only, element by element.
  [[nodiscard]] const std::vector<model::Face>& boundary() const { return boundary_; }
  /// Sides with another property beyond them.
  [[nodiscard]] const std::vector<model::Face>& property_borders() const { return borders_; }

  /// Sides of some elements, in their order, that have none for which `inside` holds beyond them.
  [[nodiscard]] std::vector<model::Face>
  sides_facing_outside(std::span<const base::ElementId> elements,
                       const std::function<bool(base::ElementId)>& inside) const;

private:
  static constexpr std::size_t most_sides = 6;
  static std::size_t place(const model::Face& face) {
    return most_sides * face.element.index() + std::size_t(face.side);
  }

  const model::Mesh& mesh_;
  NodeToElementsMap elements_;
  std::vector<std::int32_t> beyond_; ///< [most_sides * element + side] element there or -1
  std::vector<model::Face> boundary_;
  std::vector<model::Face> borders_;
};

} // namespace spricka::mesh
