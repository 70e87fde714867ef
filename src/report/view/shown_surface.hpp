// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "results/results.hpp"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace spricka::report {

/// What is seen of a mesh: the outer faces of solids, in the plane the elements themselves. Points
/// are nodes, and once more nodes where properties meet, as stresses jump there.
struct ShownSurface {
  std::vector<base::NodeId> node;     ///< [point]
  std::vector<std::size_t> source;    ///< [point] where its stress stands in the results
  std::vector<std::uint32_t> outline; ///< points round each face, one face after another
  /// [face] how many points it has; `has_mid_nodes` more where every second one is no corner.
  std::vector<std::uint32_t> kind;
  std::vector<std::uint32_t> body; ///< [face] number of its net
  /// Two places each: points of one net that lie on each other, the faces of its cracks.
  std::vector<std::uint32_t> coincident;

  static constexpr std::uint32_t has_mid_nodes = 16;
};

/// The surface of a length with all its nodes.
ShownSurface make_shown_surface(const results::CrackLengthResult& increment);

} // namespace spricka::report
