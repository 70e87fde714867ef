// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/source.hpp"
#include "base/units.hpp"

#include <string>

namespace spricka::report {

/// The deck's unit of a parameter that the deck gives as a number with a unit, `delta = 84[um]`:
/// "mm" in a deck of mm and N, where the parameter's value is in it. Empty where the deck does not
/// say what the number is.
std::string find_parameter_unit(const base::SourceTexts& sources, const base::UnitSystem& system,
                                const std::string& name);

} // namespace spricka::report
