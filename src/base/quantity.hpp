// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/units.hpp"

#include <numbers>
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
  energy,
  life ///< cycles or passes of a spectrum
};

/// The unit that such a number has: "MPa*mm^0.5"; of angles "rad", of plain numbers nothing.
std::string unit_name(const UnitSystem& units, QuantityKind quantity);

/// Degrees in a radian: angles are written in degrees.
inline constexpr double degrees_per_radian = 180.0 / std::numbers::pi;

/// What such a number is written in; lives as they are counted, see results::life_unit.
OutputUnit output_unit(const UnitSystem& units, QuantityKind quantity);

} // namespace spricka::base
