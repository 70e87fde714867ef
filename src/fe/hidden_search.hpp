// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/vec.hpp"

#include <array>
#include <functional>

/// Looks for values of a field between the points at which a quadrature rule has seen it.
namespace spricka::fe {

/// A part low <= t <= high of the unit cube of an element (unit_cube_point).
struct UnitBox {
  std::array<double, 3> low{}, high{};
};

/// Values of a field at some points, by component.
struct SeenValues {
  base::Vec3 low = base::Vec3::Zero();
  base::Vec3 high = base::Vec3::Zero();
};

struct SearchSettings {
  double little = 0.0; ///< values that leave those seen by no more are no find
  double room = 0.0;   ///< so much of the integral over the unit cube may stay open
  int most_bounds = 300;
};

struct SearchResult {
  bool found = false;
  UnitBox place;     ///< of the find
  double open = 0.0; ///< part of the integral over the unit cube that nothing was known about
};

/// By how much a component of a field may leave the values seen in a box at most.
using HiddenBound = std::function<double(const UnitBox&, const SeenValues& seen)>;
/// The field at a point of the unit cube.
using UnitCubeField = std::function<base::Vec3(const std::array<double, 3>& t)>;

/// Branch and bound (Land, Doig 1960) in the first `dim` directions of the unit cube. A box is
/// halved in the direction that leaves its halves the least to hide, the largest doubt first; what
/// is known no better than "anything" at the end does not count as open, rules that disagree have
/// to tell that.
SearchResult search_hidden(std::size_t dim, const HiddenBound& bounds, const UnitCubeField& value,
                           const UnitBox& box, const SeenValues& seen,
                           const SearchSettings& settings);

} // namespace spricka::fe
