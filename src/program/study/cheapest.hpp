// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "program/study/verdict.hpp"

#include <vector>

namespace spricka::program {

/// For 1, 0.1 and 0.01 %: the setting of the least CPU (within 15 % of it, of the fewest freedoms)
/// whose error, and that of all finer ones of its family, is below it together with what the
/// references are uncertain by. CalculiX is not among them.
std::vector<CheapestSetting> cheapest_settings(const GroupVerdict& group,
                                               const std::vector<Trial>& trials);

/// A part as per cent with two digits, "0.023 %"; "-" where it is not finite.
std::string percent(double part);

} // namespace spricka::program
