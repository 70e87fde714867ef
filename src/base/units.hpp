// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/output_unit.hpp"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace spricka::base {

/// Exponents of a quantity in length, force and angle; K is {-1.5, 1, 0}.
struct PhysicalDimension {
  double length = 0.0;
  double force = 0.0;
  double angle = 0.0;
  bool operator==(const PhysicalDimension&) const = default;
};

/// The deck's units: names as the deck writes them and their size in m and N.
struct UnitSystem {
  std::string length_name = "mm";
  std::string force_name = "N";
  double metre_per_length = 1e-3;
  double newton_per_force = 1.0;
  OutputUnitChoice output; ///< of what is written for a reader

  [[nodiscard]] std::string stress_name() const; ///< "MPa", "Pa", "psi" where there is one
  [[nodiscard]] std::string stress_intensity_name() const; ///< "MPa*mm^0.5"

  // What lengths, forces, stresses and K are written in: the deck's units unless it chooses others.
  [[nodiscard]] OutputUnit output_length() const;
  [[nodiscard]] OutputUnit output_force() const;
  [[nodiscard]] OutputUnit output_stress() const;
  [[nodiscard]] OutputUnit output_stress_intensity() const;
};

/// A parsed unit: value in SI (m, N, rad) of one such unit, and its dimension.
struct PhysicalUnit {
  double si = 1.0;
  PhysicalDimension dimension;
};

/// A unit that the language knows by name; products, quotients and powers are made of these.
struct NamedUnit {
  std::string_view name;
  PhysicalUnit unit;
};
/// All units with a name, in the order of the help.
std::vector<NamedUnit> unit_words();

/// Reads the text between [ and ]: m mm um in, N kN MN lbf kip, Pa kPa MPa GPa psi ksi, deg rad
/// cycle with * / and ^. Empty when a word or the form is unknown.
std::optional<PhysicalUnit> parse_unit(std::string_view text);

/// Factor that turns a number in `unit` into deck units.
double factor_to_deck_units(const PhysicalUnit& unit, const UnitSystem& system);

/// A unit that numbers of the deck are to be written in, by the text that names it; its name has
/// roots as powers, "MPa*m^0.5" for "MPa*sqrt(m)". Empty where the text is no unit.
std::optional<OutputUnit> make_output_unit(std::string_view text, const UnitSystem& system);

/// $DECK's LENGTH (M, MM, IN) and FORCE (N, KN, LBF), any case; empty when unknown.
std::optional<UnitSystem> make_unit_system(std::string_view length, std::string_view force);

} // namespace spricka::base
