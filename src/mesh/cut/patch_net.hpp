// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/element_type.hpp"
#include "mesh/cut/crack_frame.hpp"
#include "mesh/quality.hpp"
#include "model/mesh.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

/// What fills a cavity of a host, its nodes and elements: how they are collected, and looked at.
namespace spricka::mesh {

/// A node of a patch: one of the host's, or new.
struct PatchNode {
  base::Vec3 x = base::Vec3::Zero();
  base::Vec3 local = base::Vec3::Zero(); ///< in the crack's frame, rounded; in the plane z = 0
  base::NodeId host;
};

struct PatchElement {
  base::ElementType type = base::ElementType::trimc6;
  std::vector<int> nodes;
};

/// A node that takes the displacement of its place on an edge or a face of others.
struct PatchTie {
  int slave = 0;
  std::vector<int> master;
  std::vector<double> weight; ///< as many
};

using PatchTriangle = std::array<int, 3>;

/// A side of the host and the sides of the patch in its place, by corners: edges of a plane patch
/// from end to end. Sides that end at a crack may be there twice, with the nodes of either face.
using HostFaceReplacement = std::pair<model::Face, std::vector<std::vector<int>>>;

/// What takes the place of an edge of a host of solids that a held set has: nodes of the patch,
/// both of a mouth that it ends at.
struct HeldSetEdgeReplacement {
  std::array<base::NodeId, 3> host; ///< ends and middle, invalid in linear elements
  std::vector<int> ends;
  int mid = -1; ///< none: what lies there belongs to another piece
};

/// What fills a cavity of a host, in the plane or in space.
struct Patch {
  std::vector<PatchNode> nodes;
  std::vector<PatchElement> elements;
  std::vector<PatchTie> ties;
  std::vector<HostFaceReplacement> faces;    ///< of the cavity that belonged to its elements
  std::vector<HeldSetEdgeReplacement> edges; ///< of the cavity that held sets have
  std::string trouble;                       ///< why there is no patch
};

/// Collects nodes, elements and ties of a patch; an edge has one node in its middle.
class PatchMeshBuilder {
public:
  /// Both must outlive the net.
  PatchMeshBuilder(const model::Mesh& host, const CrackFrame& frame) : host_(host), frame_(frame) {}

  int find_or_add_host_node(base::NodeId n);
  int add_node_at_position(const base::Vec3& x);
  /// At a place in the crack's frame, which is not rounded.
  int add_node_at_local_position(const base::Vec3& place);
  /// A second node in the place of another.
  int duplicate_node(int n);

  /// The node in the middle of an edge, made half way if the edge has none.
  int find_or_add_mid_node(int a, int b);
  [[nodiscard]] std::optional<int> find_mid_node(int a, int b) const;
  void set_mid_node(int a, int b, int node) { mid_.insert_or_assign(key(a, b), node); }
  /// Adds a quadratic element of these corners, with the nodes in the middle of its edges.
  void add_element(base::ElementType type, std::span<const int> corners);

  [[nodiscard]] const base::Vec3& position(int n) const {
    return nodes[static_cast<std::size_t>(n)].x;
  }
  [[nodiscard]] const base::Vec3& local_position(int n) const {
    return nodes[static_cast<std::size_t>(n)].local;
  }
  /// Six times the volume of a tetrahedron, by rounded coordinates.
  [[nodiscard]] double six_times_volume(int a, int b, int c, int d) const;

  /// Moves nodes, elements and ties into a patch.
  void move_into_patch(Patch& patch);

  std::vector<PatchNode> nodes;
  std::vector<PatchElement> elements;
  std::vector<PatchTie> ties;

private:
  static std::uint64_t key(int a, int b) {
    const auto [low, high] = std::minmax(a, b);
    return (static_cast<std::uint64_t>(low) << 32U) | static_cast<std::uint64_t>(high);
  }

  const model::Mesh& host_;
  const CrackFrame& frame_;
  std::unordered_map<std::int32_t, int> of_host_;
  std::unordered_map<std::uint64_t, int> mid_;
};

/// Of these elements of a patch, ascending, those that are folded (find_mesh_faults), by their
/// numbers there.
std::vector<InvalidElement> find_folded_elements(std::span<const PatchNode> nodes,
                                                 std::span<const PatchElement> elements,
                                                 const std::vector<std::size_t>& asked);

/// Of all elements of a patch.
std::vector<InvalidElement> find_folded_elements(std::span<const PatchNode> nodes,
                                                 std::span<const PatchElement> elements);

/// The one with the least determinant, the first of several; of at least one.
const InvalidElement& most_folded_element(const std::vector<InvalidElement>& folded);

} // namespace spricka::mesh
