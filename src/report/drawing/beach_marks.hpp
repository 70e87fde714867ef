// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/output_unit.hpp"
#include "base/vec.hpp"

#include <string>
#include <vector>

namespace spricka::report {

/// A crack's fronts at one moment of its growth.
struct BeachMark {
  std::vector<std::vector<base::Vec3>> fronts; ///< points along each
  double cycles = 0.0;
};

/// Fronts of one crack, in the order of its growth, as marks on the face of the crack.
struct BeachMarkView {
  std::string title;
  base::Vec3 right = base::Vec3::UnitX(); ///< unit, in the crack's plane
  base::Vec3 up = base::Vec3::UnitY();
  std::vector<BeachMark> marks;
  base::OutputUnit length; ///< of the bar
  double width = 560.0;    ///< [CSS pixels]
};

/// Seen along the normal, both directions to one scale; cycles beside marks that have room for
/// them. Empty: there is nothing to be seen.
std::string draw_svg(const BeachMarkView& view);

} // namespace spricka::report
