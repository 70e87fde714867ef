// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "geometry/box_tree.hpp"
#include "model/mesh.hpp"

#include <vector>

namespace spricka::sense {

/// A part of a mesh's boundary, faces and nodes, that one can ask whether a point lies on it: up to
/// 3e-3 of the size of a face, as curved sides of two meshes of one body differ, and to 1e-6 of the
/// whole mesh on a node.
class BoundaryPart {
public:
  BoundaryPart(const model::Mesh& mesh, std::vector<model::Face> faces,
               const std::vector<base::NodeId>& nodes = {});

  /// Whether a point lies on one of the faces or nodes, within the tolerance of each.
  [[nodiscard]] bool contains_point(const base::Vec3& x) const;
  /// Nodes of the faces and their centres, and the nodes: contains_point() is true of each.
  [[nodiscard]] const std::vector<base::Vec3>& samples() const { return samples_; }

private:
  [[nodiscard]] bool lies_plainly_on(std::size_t face, const base::Vec3& x, double allowed) const;

  const model::Mesh& mesh_;
  std::vector<model::Face> faces_;
  std::vector<double> size_; ///< [face]
  std::vector<base::Vec3> points_;
  double same_point_ = 0.0;
  std::vector<base::Vec3> samples_; ///< centres of faces, their nodes, then points
  geometry::BoxTree<3> tree_;       ///< faces, then points
};

} // namespace spricka::sense
