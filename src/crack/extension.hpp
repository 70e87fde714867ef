// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/id.hpp"
#include "base/vec.hpp"
#include "mesh/cut/cracked.hpp"
#include "mesh/node_elements.hpp"
#include "model/mesh.hpp"

#include <cstdint>
#include <map>
#include <vector>

/// Virtual extension fields: how far each node moves along with the tip.
namespace spricka::crack {

/// A node moves by q along the growth direction of the point of the front that it goes with, a unit
/// vector; at the end of a front in space also along the front, so that it keeps to the surface.
struct NodeMotion {
  base::NodeId node;
  double q = 0.0;
  base::Vec3 along = base::Vec3::UnitX();
};

/// q of one domain: 1 at the tip and on every node of `rings` rings of elements round it, 0 beyond
/// the ring after; mid nodes in between take the mean of their corners.
struct VirtualExtensionField {
  int rings = 1;
  std::vector<NodeMotion> motion;        ///< nodes with q > 0, ascending
  std::vector<base::ElementId> elements; ///< where q is not constant, ascending
  std::vector<base::ElementId> inside;   ///< where q is 1, ascending

  [[nodiscard]] std::map<base::NodeId, double> extension_by_node() const; ///< by node
};

/// Which face of the crack a point lies on: there theta is pi or -pi, whatever round-off makes of
/// it.
enum class UpperOrLowerFace { none, upper, lower };

/// A free side of an element that a domain moves.
struct MovedFreeSide {
  model::Face face;
  UpperOrLowerFace on = UpperOrLowerFace::none; ///< which face of the crack, if it is one
};

/// What domains must keep clear of, beside what the mesh says; empty: nothing.
struct IntegrationDomainConstraints {
  std::vector<bool> node; ///< [node] must not move
  /// [element] not negative: a domain stays in one, on each side of the tip's line; empty: the
  /// element's property
  std::vector<std::int64_t> zone;
};

/// Nodes and elements round the tips, found once for each mesh.
class TipNeighbourhood {
public:
  explicit TipNeighbourhood(const model::Mesh& mesh);

  /// Fields for the ring counts asked for. A domain that would move a node of the outer boundary
  /// (the crack's own faces behind the tip and, for a half model, the symmetry line excepted),
  /// reach another tip, a node of the limits, or leave the tip's property or zone is left out and
  /// named in `left_out`.
  [[nodiscard]] std::vector<VirtualExtensionField>
  extension_fields(const mesh::CrackedMesh& cracked, const mesh::CrackFront& front,
                   const std::vector<int>& rings, std::vector<int>& left_out,
                   const IntegrationDomainConstraints& limits = {}) const;

private:
  [[nodiscard]] bool on_boundary(base::NodeId n) const;
  [[nodiscard]] VirtualExtensionField field(const mesh::CrackFront& front, int rings) const;

  const model::Mesh& mesh_;
  mesh::NodeToElementsMap elements_;
};

} // namespace spricka::crack
