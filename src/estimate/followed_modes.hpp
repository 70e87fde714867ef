// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "estimate/contact_edges.hpp"
#include "estimate/enrichment.hpp"

#include <vector>

namespace spricka::estimate {

/// The normal mode of an edge of the coarser surface of a pair whose meshes do not match, with what
/// the other body has to do to stay in touch (manual, estimate.14).
struct FollowedMode {
  std::size_t edge = 0; ///< whose mode it is
  std::vector<std::size_t>
      rows; ///< normal rows of the pair: all closed, or the mode does not count
  struct Node {
    base::NodeId node;
    base::Vec2 motion = base::Vec2::Zero(); ///< by a unit of the mode
  };
  std::vector<Node> nodes; ///< of the other surface that lie opposite
  struct Mode {
    std::size_t edge = 0;
    double factor = 0.0; ///< of its normal mode
  };
  std::vector<Mode> modes; ///< of the other surface's edges
  double stiffness = 0.0;  ///< of the mode and what follows it, estimated [force/length]
};

/// The followed modes of a pair, in the order of its edges.
std::vector<FollowedMode> followed_modes(const Enrichment& enrichment,
                                         const std::vector<ContactEdge>& edges,
                                         const contact::PairRows& pair);

/// What those of a pair add to the parts of eta, by edge and goal [mode, goals]: r_u and r_z are
/// the residuals of the modes [freedoms] and [freedoms, goals], the contact forces of the pair's
/// normal rows those of the step [dim * node] and of the adjoints [dim * node, goals].
struct FollowedResiduals {
  const base::Vector& r_u;
  const base::Matrix& r_z;
  const base::Vector& force_u;
  const base::Matrix& force_z;
};
base::Matrix followed_parts(const std::vector<FollowedMode>& modes, const std::vector<bool>& closed,
                            const FollowedResiduals& residuals);

} // namespace spricka::estimate
