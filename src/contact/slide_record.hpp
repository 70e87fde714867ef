// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/vec.hpp"

#include <optional>
#include <span>
#include <vector>

namespace spricka::contact {

/// Part of the largest pressure: where there is less nothing is looked at.
inline constexpr double least_looked_at = 0.01;

/// Where thrust acts on the target, once displacements have taken it there; of a rigid target where
/// the contact side is then.
struct DisplacedContactPoint {
  base::Vec3 x = base::Vec3::Zero();
  double thrust = 0.0; ///< [force]
  double gap = 0.0;    ///< as rows count it, to the contact side [length]
  /// Gap of the deformed bodies that no row counts [length]; none: nothing stands opposite any
  /// more.
  std::optional<double> unseen;
  base::Vector opening; ///< [motion] what each motion that was asked for adds to the gap
};

/// How far the pressed part of a pair has moved.
struct SlideMeasures {
  double thrust = 0.0; ///< sum of pressure times area [force]
  /// Part of the thrust that acts where nothing stands opposite any more.
  double unsupported_part = 0.0;
  double way = 0.0;     ///< largest slide of one side along the other [length]
  double facet = 0.0;   ///< longest edge of either side where that is [length]
  double pressed = 0.0; ///< length of the pressed part
  double misfit = 0.0;  ///< largest gap of the deformed bodies that no row counts [length]
  std::vector<DisplacedContactPoint> places;
};

/// What motions [dim * node, n] add to a gap, one after the other, by `opening` of one of them.
template <class Opening>
base::Vector openings(std::span<const base::Matrix* const> motions, const Opening& opening) {
  std::vector<double> found;
  for (const base::Matrix* motion : motions) {
    for (Eigen::Index j = 0; j < motion->cols(); ++j) {
      found.push_back(opening(motion->col(j)));
    }
  }
  return Eigen::Map<const base::Vector>(found.data(), static_cast<Eigen::Index>(found.size()));
}

} // namespace spricka::contact
