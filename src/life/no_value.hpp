// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <limits>

namespace spricka::life {

/// A rate, length or number of cycles that there is none of.
inline constexpr double no_value = std::numeric_limits<double>::quiet_NaN();

} // namespace spricka::life
