// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "mesh/cut/cracked.hpp"

#include <span>
#include <utility>
#include <vector>

namespace spricka::mesh {

/// Which faces of cracks the members of a node set lie on. A crack doubles the nodes of its path;
/// a set means the face that its own sides lie on: a clamp that ends at a mouth holds the face on
/// its side, one that goes on across the mouth holds both.
class NodeSetsOnCrackFaces {
public:
  /// The mesh with all cracks open. Half crack faces double nothing.
  NodeSetsOnCrackFaces(const model::Mesh& mesh, std::span<const CrackFaceNodes> crack_faces);

  /// Nodes of one place, and those of them that belong to a set.
  struct ChosenCoincidentNodes {
    std::vector<base::NodeId> nodes; ///< first the host's own
    std::vector<base::NodeId> chosen;
    /// No side of the set tells a face, nor does the set go along the crack: all are chosen.
    bool alone = false;
  };
  /// For each place of which a set has at least one node. A node belongs to the set where a side of
  /// an element at it, but for sides of the crack itself, has both its corners in the set; a middle
  /// node where a corner next to it on its face does.
  [[nodiscard]] std::vector<ChosenCoincidentNodes>
  choose_nodes_belonging_to_set(const std::vector<base::NodeId>& members) const;

  /// All nodes at the place of a doubled node, itself among them; empty for others.
  [[nodiscard]] std::span<const base::NodeId> coincident_nodes(base::NodeId node) const;

private:
  struct SideTouchingCrack {
    base::NodeId a, b;
    bool along = false; ///< a side of the crack
  };
  void add_group(base::NodeId left, base::NodeId right);
  void add_neighbours(const std::vector<base::NodeId>& crack_face);
  void find_sides(const model::Mesh& mesh, std::span<const CrackFaceNodes> crack_faces);

  std::vector<std::int32_t> group_of_; ///< [node] or -1
  std::vector<bool> corner_;           ///< [node]
  std::vector<std::vector<base::NodeId>> groups_;
  std::vector<SideTouchingCrack> sides_; ///< that have a corner among the groups
  /// Middle nodes of faces with the corners next to them.
  std::vector<std::pair<base::NodeId, base::NodeId>> beside_;
};

/// Puts the nodes that cracks have made into the node sets of the host's, face by face.
void add_crack_face_nodes(model::Mesh& mesh, std::span<const CrackFaceNodes> crack_faces);

} // namespace spricka::mesh
