// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/id.hpp"

namespace spricka::base {

/// Eighteen digits: numbers of meshes put together stay far from the largest integer.
inline constexpr Label largest_label = 999'999'999'999'999'999;

} // namespace spricka::base
