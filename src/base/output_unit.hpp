// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <optional>
#include <string>

namespace spricka::base {

/// A unit that numbers are written in. Numbers of the program are in units of the deck; what is
/// written is one of them times `multiplier` over `divisor`: as a fraction round factors are exact.
struct OutputUnit {
  std::string name; ///< "MPa*m^0.5"; empty of plain numbers
  double multiplier = 1.0;
  double divisor = 1.0;

  /// A number in units of the deck as it is written.
  [[nodiscard]] double from_deck(double value) const { return value * multiplier / divisor; }
  /// The same with that many digits and the name: "25.4 mm".
  [[nodiscard]] std::string text(double value, int digits) const;
  /// A number in this unit, in units of the deck.
  [[nodiscard]] double to_deck(double value) const { return value * divisor / multiplier; }
};

/// The unit of a product: "N*mm".
OutputUnit operator*(const OutputUnit& a, const OutputUnit& b);
/// The unit of a quotient: "N/mm".
OutputUnit operator/(const OutputUnit& a, const OutputUnit& b);
/// The unit of a whole power of at least 2: "mm^2".
OutputUnit raised(const OutputUnit& unit, int exponent);

/// What lives are written in.
enum class LifeUnit { as_counted, cycles, thousand_cycles, passes };

/// Units of output that are not those of the deck.
struct OutputUnitChoice {
  std::optional<OutputUnit> length;
  std::optional<OutputUnit> force;
  std::optional<OutputUnit> stress;
  std::optional<OutputUnit> stress_intensity;
  LifeUnit life = LifeUnit::as_counted;
  /// Whether anything is written in other units than the deck's.
  [[nodiscard]] bool is_any() const {
    return length || force || stress || stress_intensity || life != LifeUnit::as_counted;
  }
};

} // namespace spricka::base
