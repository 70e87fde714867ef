// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/output_unit.hpp"
#include "base/vec.hpp"

#include <string>

namespace spricka::base {

/// The number with few decimal digits that `value` is but for the rounding of a sum, 3.6 for
/// 3.6000000000000014; `value` itself where there is none.
double restore_short_decimal(double value);

/// A place for people: (x, y), in space (x, y, z), with six digits, in a unit of output where one
/// is given.
std::string format_coordinates(const Vec3& x, int dim, const OutputUnit& unit = {});

} // namespace spricka::base
