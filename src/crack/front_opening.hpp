// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "crack/front_setting.hpp"

#include <array>
#include <optional>

namespace spricka::crack {

/// K1, K2 and K3 at a point of the front by the displacement of the crack's faces against each
/// other at the first node behind it, scaled so that they release G (crack_space.17). Nothing where
/// an edge of the crack's faces does not lead from the point to such a node, or G is not positive.
std::optional<std::array<double, 3>> front_K_from_face_opening(const FrontContext& set,
                                                               const mesh::CrackFaceNodes& faces,
                                                               const mesh::FrontPoint& point,
                                                               double G, const base::Vector& u);

} // namespace spricka::crack
