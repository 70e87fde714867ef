// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace spricka::base {

/// The number with few decimal digits that `value` is but for the rounding of a sum, 3.6 for
/// 3.6000000000000014; `value` itself where there is none.
double tidy(double value);

} // namespace spricka::base
