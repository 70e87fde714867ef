// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/units.hpp"

#include <string>

namespace spricka::base {

/// What a number of a deck or of a result measures, and so its unit.
enum class QuantityKind {
  number,
  length,
  area,
  stress,
  angle,
  stress_intensity,
  force,
  energy_release,
  energy
};

/// The unit that such a number has: "MPa*mm^0.5"; of angles "rad", of plain numbers nothing.
std::string unit_name(const UnitSystem& units, QuantityKind quantity);

} // namespace spricka::base
