// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/vec.hpp"
#include "contact/surface.hpp"

#include <map>
#include <vector>

namespace spricka::contact {

using Numbering = std::map<base::NodeId, Eigen::Index>;

/// Pressures from multipliers on half edges without what alternates between corners and middles
/// (contact.15): such waves do next to no work on quadratic triangles. `sound` [edges, chain by
/// chain]: wholly paired and closed; only these are smoothed, and corners where such edges meet or
/// where the surface ends. `lambda` and `pressure` [node, as numbered]; linear edges stay as they
/// are.
void filter_alternating_pressure(const ContactSurface& surface, const Numbering& number,
                                 const std::vector<bool>& sound, const base::Vector& lambda,
                                 base::Vector& pressure);

} // namespace spricka::contact
