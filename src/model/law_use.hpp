// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <limits>

namespace spricka::model {

/// Of the cycles that grow: what a law was asked for, and how many of them lie outside the data
/// behind it. Delta K is that of the law, K_max - K_min where it counts R < 0.
struct LawUse {
  double lowest_delta_k = std::numeric_limits<double>::infinity(); ///< none: above the highest
  double highest_delta_k = -std::numeric_limits<double>::infinity();
  double lowest_ratio = std::numeric_limits<double>::infinity();
  double highest_ratio = -std::numeric_limits<double>::infinity();
  double outside = 0.0;        ///< part of the cycles
  double growth_outside = 0.0; ///< the part of the growth that these make
  double below_delta_k = 0.0;  ///< parts of the cycles by side; one may lie on two
  double above_delta_k = 0.0;
  double below_ratio = 0.0;
  double above_ratio = 0.0;
};

} // namespace spricka::model
