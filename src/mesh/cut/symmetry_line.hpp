// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "mesh/cut/cavity.hpp"
#include "mesh/cut/patch_net.hpp"

#include <vector>

namespace spricka::mesh {

/// The edges of the host along which a symmetric half of a crack and its ligament run, ahead of the
/// mouth on the x axis of its frame, and what takes their place.
class SymmetryLine {
public:
  SymmetryLine(const model::Mesh& host, const CrackFrame& frame) : host_(host), frame_(frame) {}

  /// Whether an edge of the cavity's outline lies on the line.
  [[nodiscard]] bool contains(const CavityOutlineEdge& edge) const;
  void add_edge(const CavityOutlineEdge& edge) { edges_.push_back(edge); }

  /// The node of these edges that lies farthest ahead.
  struct SymmetryLineEnd {
    base::NodeId node;
    double x = 0.0;
  };
  [[nodiscard]] SymmetryLineEnd farthest_end() const;

  /// The edges between nodes of the patch along the whole line, in the direction of growth: each
  /// belongs to the host edge that its middle lies on.
  [[nodiscard]] std::vector<HostFaceReplacement>
  edge_replacements(const PatchMeshBuilder& net, const std::vector<int>& line) const;

private:
  const model::Mesh& host_;
  CrackFrame frame_;
  std::vector<CavityOutlineEdge> edges_;
};

/// Puts the contour of a half into the loop that has its ends, in the place of what lies between
/// them there; false if none has.
bool insert_contour_into_loop(std::vector<std::vector<int>>& loops,
                              const std::vector<int>& contour);

} // namespace spricka::mesh
