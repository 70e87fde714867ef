// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/quantity.hpp"

namespace spricka::base {

std::string unit_name(const UnitSystem& units, QuantityKind quantity) {
  switch (quantity) {
  case QuantityKind::length:
    return units.length_name;
  case QuantityKind::area:
    return units.length_name + "^2";
  case QuantityKind::stress:
    return units.stress_name();
  case QuantityKind::angle:
    return "rad";
  case QuantityKind::stress_intensity:
    return units.stress_intensity_name();
  case QuantityKind::force:
    return units.force_name;
  case QuantityKind::energy_release:
    return units.force_name + "/" + units.length_name;
  case QuantityKind::energy:
    return units.force_name + "*" + units.length_name;
  case QuantityKind::number:
  case QuantityKind::life:
    break;
  }
  return {};
}

OutputUnit output_unit(const UnitSystem& units, QuantityKind quantity) {
  switch (quantity) {
  case QuantityKind::length:
    return units.output_length();
  case QuantityKind::area:
    return raised(units.output_length(), 2);
  case QuantityKind::stress:
    return units.output_stress();
  case QuantityKind::angle:
    return {"deg", degrees_per_radian, 1.0};
  case QuantityKind::stress_intensity:
    return units.output_stress_intensity();
  case QuantityKind::force:
    return units.output_force();
  case QuantityKind::energy_release:
    return units.output_force() / units.output_length();
  case QuantityKind::energy:
    return units.output_force() * units.output_length();
  case QuantityKind::number:
  case QuantityKind::life:
    break;
  }
  return {};
}

} // namespace spricka::base
