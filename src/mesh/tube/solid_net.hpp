// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/element_type.hpp"
#include "mesh/tube/solid_frame.hpp"
#include "model/mesh.hpp"

#include <array>
#include <cstdint>
#include <optional>
#include <unordered_map>
#include <utility>
#include <vector>

namespace spricka::mesh {

/// A node of a patch in space: one of the host's, or new.
struct SolidPatchNode {
  base::Vec3 x = base::Vec3::Zero();
  base::Vec3 local = base::Vec3::Zero(); ///< in the crack's frame, rounded
  base::NodeId host;
};

struct SolidPatchElement {
  base::ElementType type = base::ElementType::tet10;
  std::vector<int> nodes;
};

/// A node that takes the displacement of its place on a face or an edge of others.
struct SolidTie {
  int slave = 0;
  std::vector<int> master;
  std::vector<double> weight;
};

using PatchTriangle = std::array<int, 3>;

/// Collects nodes, elements and ties of a patch; an edge has one node in its middle.
class SolidPatchNet {
public:
  SolidPatchNet(const model::Mesh& host, const SolidCrackFrame& frame)
      : host_(host), frame_(frame) {}

  int host_node(base::NodeId n);
  int new_node(const base::Vec3& x);
  /// At a place in the crack's frame, which is not rounded.
  int new_node_at(const base::Vec3& place);
  /// A second node in the place of another.
  int duplicate_node(int n);

  /// The node in the middle of an edge, made half way if the edge has none.
  int mid_node(int a, int b);
  [[nodiscard]] std::optional<int> known_mid_node(int a, int b) const;
  void set_mid_node(int a, int b, int node) { mid_.insert_or_assign(key(a, b), node); }

  [[nodiscard]] const base::Vec3& position(int n) const {
    return nodes[static_cast<std::size_t>(n)].x;
  }
  [[nodiscard]] const base::Vec3& local_position(int n) const {
    return nodes[static_cast<std::size_t>(n)].local;
  }
  /// Six times the volume of a tetrahedron, by rounded coordinates.
  [[nodiscard]] double six_volumes(int a, int b, int c, int d) const;

  std::vector<SolidPatchNode> nodes;
  std::vector<SolidPatchElement> elements;
  std::vector<SolidTie> ties;

private:
  static std::uint64_t key(int a, int b) {
    const auto [low, high] = std::minmax(a, b);
    return (static_cast<std::uint64_t>(low) << 32U) | static_cast<std::uint64_t>(high);
  }

  const model::Mesh& host_;
  const SolidCrackFrame& frame_;
  std::unordered_map<std::int32_t, int> of_host_;
  std::unordered_map<std::uint64_t, int> mid_;
};

} // namespace spricka::mesh
