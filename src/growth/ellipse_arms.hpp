// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "growth/ellipse_ways.hpp"

#include <cstddef>
#include <vector>

namespace spricka::growth {

/// The tip that moves the arm of another one: its own, or behind a meeting that of the crack which
/// the two have become.
std::size_t mover_of(const std::vector<EllipseWays::Arm>& arms, std::size_t tip);

} // namespace spricka::growth
