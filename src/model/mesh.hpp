// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/element_type.hpp"
#include "base/id.hpp"
#include "base/source.hpp"
#include "base/vec.hpp"

#include <span>
#include <string>
#include <vector>

namespace spricka::model {

/// A side of an element: an edge in 2D, a face in 3D. Side s of an element has the nodes
/// shape::side_nodes(type, s).
struct Face {
  base::ElementId element;
  int side = 0;
  auto operator<=>(const Face&) const = default;
};

/// Sets keep their order (crack paths are ordered). Names are upper case and qualified, "LUG.BORE";
/// sets outside every net have no prefix; nameless sets stand behind item lists of single cards.
struct NodeSet {
  std::string name;
  std::vector<base::NodeId> nodes;
  base::SourceSpan span;
};
struct ElementSet {
  std::string name;
  std::vector<base::ElementId> elements;
  base::SourceSpan span;
};
struct FaceSet {
  std::string name;
  std::vector<Face> faces;
  base::SourceSpan span;
};

/// Nodes and elements of all nets together. A net is a label on nodes and elements; bodies that
/// share no node are independent whatever net they stand in. 2D meshes have z = 0 everywhere.
struct Mesh {
  int dim = 2;

  std::vector<base::Vec3> x;           ///< [node] coordinates, deck length
  std::vector<base::Label> node_label; ///< [node]
  std::vector<base::NetId> node_net;   ///< [node]

  std::vector<base::ElementType> type;    ///< [element]
  std::vector<std::int32_t> first;        ///< [element + 1] into `nodes`
  std::vector<base::NodeId> nodes;        ///< connectivity of all elements, one after another
  std::vector<base::Label> element_label; ///< [element]
  std::vector<base::NetId> element_net;   ///< [element]
  std::vector<base::PropertyId> property; ///< [element]; invalid until $PROPERTY is bound

  std::vector<NodeSet> node_sets;
  std::vector<ElementSet> element_sets;
  std::vector<FaceSet> face_sets;

  [[nodiscard]] std::size_t node_count() const { return x.size(); }
  [[nodiscard]] std::size_t element_count() const { return type.size(); }
  /// Nodes of an element in the order of its type, a view into `nodes`.
  [[nodiscard]] std::span<const base::NodeId> element_nodes(base::ElementId e) const {
    const auto begin = static_cast<std::size_t>(first[e.index()]);
    return {nodes.data() + begin, static_cast<std::size_t>(first[e.index() + 1]) - begin};
  }
  /// The node set of an id, which must be valid.
  [[nodiscard]] const NodeSet& set_with_id(base::NodeSetId id) const {
    return node_sets[id.index()];
  }
  /// The element set of an id, which must be valid.
  [[nodiscard]] const ElementSet& set_with_id(base::ElementSetId id) const {
    return element_sets[id.index()];
  }
  /// The face set of an id, which must be valid.
  [[nodiscard]] const FaceSet& set_with_id(base::FaceSetId id) const {
    return face_sets[id.index()];
  }
};

/// The elements of a mesh in their order.
std::vector<base::ElementId> all_elements(const Mesh& mesh);

/// Which of `count` things, nodes or elements, are among the members of a set [thing].
template <class Id> std::vector<bool> mark_members(std::size_t count, const std::vector<Id>& set) {
  std::vector<bool> member(count, false);
  for (const Id id : set) {
    member[id.index()] = true;
  }
  return member;
}

/// The mean of the corners of an element.
base::Vec3 element_corner_mean(const Mesh& mesh, base::ElementId e);

/// Which nodes belong to an element [node]: nodes of references and what a crack patch replaced do
/// not.
std::vector<bool> mark_nodes_in_use(const Mesh& mesh);

/// Radius below which a node lies on the axis x = 0 of a mesh about it: 1e-9 of the largest.
double axis_tolerance(const Mesh& mesh);

/// Makes room for so many nodes, elements and entries of the connectivity in all.
void reserve(Mesh& mesh, std::size_t nodes, std::size_t elements, std::size_t entries);

/// Appends a node and returns its index.
base::NodeId add_node(Mesh& mesh, const base::Vec3& x, base::Label label, base::NetId net);

/// Appends an element and returns its index; its property stays open.
base::ElementId add_element(Mesh& mesh, base::ElementType type, std::span<const base::NodeId> nodes,
                            base::Label label, base::NetId net);

} // namespace spricka::model
