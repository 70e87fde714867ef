// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <span>
#include <vector>

namespace spricka::base {

/// The points where a history turns, its first and its last one; what repeats or lies on the way is
/// left out.
std::vector<double> turning_points(std::span<const double> history);

/// The points where a history turns whose end leads to its start: peaks and valleys in turn, as
/// many of either, the history's first one first; a single point where it is constant.
std::vector<double> closed_turning_points(std::span<const double> history);

} // namespace spricka::base
