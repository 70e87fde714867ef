// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "estimate/edges.hpp"
#include "fe/dependence.hpp"
#include "model/forward.hpp"

#include <array>
#include <vector>

/// Where stresses have no bound though no crack ends there: ends of supports, re-entrant corners,
/// ends and corners of material borders, nodes that are pushed or held singly. Cubic modes see a
/// part only of the error that such places make (manual, estimate.15 to 17).
namespace spricka::estimate {

struct SingularCorner {
  base::NodeId node;
  double exponent = 1.0; ///< u ~ r^exponent, below 1
  /// [x, y] a support of this node and of none of its sides
  std::array<bool, 2> held_alone{};
  std::vector<base::ElementId> elements; ///< that have the node
  std::vector<base::ElementId> around;   ///< those, and then all that touch them
};

/// What a mesh stands on. cls [2 * node]
struct CornerSearchInput {
  const model::Model& model;
  const model::Mesh& mesh;
  const EdgeTable& edges;
  const std::vector<model::FreedomRole>& cls;
  const fe::ConstraintTransformation& ties;
  const std::vector<base::NodeId>& front_nodes; ///< of cracks: their elements follow u ~ sqrt(r)
  /// [node] held by another body or a rigid one; null: none
  const std::vector<bool>* tied = nullptr;
};

/// The singular corners of a plane mesh, by their nodes. Where bodies are tied together their ends
/// are those of a support where one surface goes on past the other, which is the worst that the
/// other body can be; where both end together, and for other ties, there is none known.
std::vector<SingularCorner> find_singular_corners(const CornerSearchInput& setting);

} // namespace spricka::estimate
