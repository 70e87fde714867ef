// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/by_dimension.hpp"

#include <cstddef>
#include <string_view>

namespace spricka::report {

/// What tables of models of the plane and of space tell.
struct PlaneOrSpaceColumns {
  bool arcs;                    ///< where contacts are closed; else their areas and moments
  bool points;                  ///< of fronts, each a row; else tips
  std::size_t modes;            ///< of K
  std::string_view half_axes;   ///< of a crack
  std::string_view moment_axes; ///< of the moments of loads
};
inline constexpr base::ByDimension<PlaneOrSpaceColumns> dimension_columns{
    {.arcs = true, .points = false, .modes = 2, .half_axes = "a", .moment_axes = "z"},
    {.arcs = false, .points = true, .modes = 3, .half_axes = "ac", .moment_axes = "xyz"}};

} // namespace spricka::report
