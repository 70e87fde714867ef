// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/vec.hpp"
#include "contact/node_pressure.hpp"

#include <array>
#include <cstddef>
#include <limits>
#include <vector>

namespace spricka::contact {

/// What a pair of surfaces carries.
struct PairPressure {
  std::vector<NodePressure> nodes;                 ///< of the side that carries the multipliers
  base::Vec3 force_on_slave = base::Vec3::Zero();  ///< deck's slave
  base::Vec3 moment_on_slave = base::Vec3::Zero(); ///< about the origin
  double mean_pressure = 0.0;                      ///< normal multipliers over the part in contact
  double min_pressure = 0.0;                       ///< of the normal multipliers
  double max_pressure = 0.0;
  double max_penetration = 0.0;        ///< [length], 0 or more
  double arc_from = 0.0, arc_to = 0.0; ///< longest closed arc [rad], or arc length if straight
  int closed = 0;
  double area = 0.0; ///< of the part in contact, in space [length^2]
  /// In space: three places in `nodes` for each triangle on which pressure is linear.
  std::vector<std::array<std::size_t, 3>> triangles;
  /// In space: root mean square of what multipliers go up and down about averages, over that of the
  /// multipliers, where averages are known.
  double unrest = 0.0;
  /// In space: elements that lie across the spot where it presses most; infinite: it has no edge.
  double across_peak = std::numeric_limits<double>::infinity();
  double radius = 0.0; ///< in space, mean: the surface is one cylinder or cone; else 0 [length]
};

} // namespace spricka::contact
