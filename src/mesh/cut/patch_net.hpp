// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "mesh/plane.hpp"
#include "model/mesh.hpp"

#include <algorithm>
#include <cstddef>
#include <map>
#include <utility>
#include <vector>

namespace spricka::mesh {

/// A node of a patch: one of the host's, or new.
struct PatchNode {
  base::Vec3 x = base::Vec3::Zero();
  base::Vec2 local = base::Vec2::Zero(); ///< in the crack's frame, rounded
  base::NodeId host;
};

struct PatchElement {
  base::ElementType type = base::ElementType::trimc6;
  std::vector<int> nodes;
};

/// An edge of the cavity and the edges (from, to) of the patch that take its place, in its
/// direction.
using HeldEdgePieces = std::pair<model::Face, std::vector<std::pair<int, int>>>;

/// Collects nodes and quadratic elements of a patch; an edge gets its mid node when first met.
class PatchNet {
public:
  PatchNet(const model::Mesh& host, const PlanarCrackFrame& frame) : host_(host), frame_(frame) {}

  int host_node(base::NodeId n);
  int new_node(const base::Vec3& x);
  /// At a place in the crack's frame, which is not rounded.
  int new_node(const base::Vec2& place);
  /// The node in the middle of an edge, made half way if the edge has none.
  int mid_node(int a, int b);
  void set_mid_node(int a, int b, int node) { mid_[std::minmax(a, b)] = node; }
  void add_triangle(int a, int b, int c);
  void add_quadrilateral(int a, int b, int c, int d);

  [[nodiscard]] const base::Vec3& position(int n) const {
    return nodes[static_cast<std::size_t>(n)].x;
  }
  [[nodiscard]] const base::Vec2& local_position(int n) const {
    return nodes[static_cast<std::size_t>(n)].local;
  }

  std::vector<PatchNode> nodes;
  std::vector<PatchElement> elements;

private:
  const model::Mesh& host_;
  const PlanarCrackFrame& frame_;
  std::map<base::NodeId, int> of_host_;
  std::map<std::pair<int, int>, int> mid_;
};

} // namespace spricka::mesh
