// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/units.hpp"

#include <string_view>
#include <vector>

namespace spricka::base {

/// A unit that the language knows by name; products, quotients and powers are made of these.
struct UnitWord {
  std::string_view name;
  Unit unit;
};
std::vector<UnitWord> unit_words();

} // namespace spricka::base
