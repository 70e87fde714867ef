// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/quantity.hpp"

namespace spricka::base {

std::string unit_name(const UnitSystem& units, Quantity quantity) {
  switch (quantity) {
  case Quantity::length:
    return units.length_name;
  case Quantity::area:
    return units.length_name + "^2";
  case Quantity::stress:
    return units.stress_name();
  case Quantity::angle:
    return "rad";
  case Quantity::stress_intensity:
    return units.stress_intensity_name();
  case Quantity::force:
    return units.force_name;
  case Quantity::energy_release:
    return units.force_name + "/" + units.length_name;
  case Quantity::energy:
    return units.force_name + "*" + units.length_name;
  case Quantity::number:
    break;
  }
  return {};
}

} // namespace spricka::base
