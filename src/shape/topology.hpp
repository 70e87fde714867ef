// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/element_type.hpp"

#include <span>

namespace spricka::shape {

/// Local node numbers of side `s` of an element: corners first in the order that leaves the body
/// on the left (2D) or has the outer normal by the right-hand rule (3D), then mid nodes.
/// 2D sides: edge s joins corners s and s+1.
std::span<const int> side_nodes(base::ElementType type, int s);

} // namespace spricka::shape
