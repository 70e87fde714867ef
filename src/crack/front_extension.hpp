// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "crack/auxiliary_cache.hpp"
#include "crack/extension.hpp"
#include "crack/front_axes.hpp"
#include "crack/front_layers.hpp"
#include "mesh/cut/cracked.hpp"

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

/// Virtual extension along fronts in space: how far nodes move where one point of the front does.
namespace spricka::crack {

/// A domain that is not there: of a point of the front, and why.
struct OmittedDomain {
  std::size_t point = 0;
  int rings = 0;
  std::string why;
};

/// The domains of a front; in the plane of its one point, the tip, with `points` and `beyond`
/// alone.
struct FrontIntegralDomains {
  std::vector<std::vector<VirtualExtensionField>> points = {}; ///< [point][domain]
  std::vector<MovedFreeSide> sides = {}; ///< free sides with a node that some domain moves
  std::vector<double> station = {};      ///< [point] place on the curve, from the first point on
  std::vector<base::NodeId> middle = {}; ///< [point] mid node between it and the next, or invalid
  bool closed = false;
  std::vector<OmittedDomain> left_out = {};
  /// Of a tip: one ring of elements more than its largest domain, if that fits.
  std::optional<VirtualExtensionField> beyond = std::nullopt;
  /// Of the rule over each element that some domain strains (front_quadrature_degree).
  std::map<base::ElementId, int> degree = {};
  std::shared_ptr<AuxiliaryFieldCache> auxiliary_cache =
      nullptr; ///< what was made of them in these domains

  [[nodiscard]] bool empty() const;
  /// All elements of all domains in space, ascending.
  [[nodiscard]] std::vector<base::ElementId> elements() const;
};

/// The domains of a tip in the plane.
inline FrontIntegralDomains wrap_tip_domains(std::vector<VirtualExtensionField> fields) {
  FrontIntegralDomains domains;
  domains.points.push_back(std::move(fields));
  return domains;
}

/// Fields for the ring counts asked for, at each point of a front: the hat of the point along the
/// front, linear between points, times 1 on the nodes of so many layers of elements round the
/// front, 0 beyond the next; along m of the place, on the body's surface along it (crack_space.1).
/// A domain that would move a node of the limits (but for those that a row ties to others that move
/// alike), of another front or another crack, leave the material or the surface, or reach as far as
/// the front's centre of curvature is left out.
FrontIntegralDomains build_front_domains(const mesh::CrackedMesh& cracked,
                                         const mesh::CrackFront& front,
                                         const std::vector<int>& rings,
                                         const IntegrationDomainConstraints& limits = {});

} // namespace spricka::crack
