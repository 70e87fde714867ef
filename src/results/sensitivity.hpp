// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <array>
#include <optional>
#include <string>
#include <vector>

namespace spricka::results {

/// What K depends on; the names are those of the deck.
enum class SensitivityParameter : char {
  load,    ///< factor of a load case
  fit,     ///< normal interference of a contact, a gap counts negative [length]
  modulus, ///< Young's modulus of a material [stress]
  length,  ///< crack length at a tip, or semi-axis A of an ellipse [length]
  axis     ///< semi-axis C of an ellipse [length]
};

/// Derivatives of K1, K2, K3 along a front by one value, everything else kept.
struct Sensitivity {
  SensitivityParameter cause = SensitivityParameter::load;
  std::string name;   ///< load case, contact, material, tip or crack
  double value = 0.0; ///< at the end of the step
  /// [point] below and above the value; different where a contact is about to change there. Empty:
  /// on that side nothing holds a body.
  std::vector<std::array<double, 3>> below, above;
  /// Values between which the contact stays as it is, infinite where it always does; empty: not
  /// known for this cause.
  std::optional<std::array<double, 2>> range;

  /// Whether both sides are known and agree.
  [[nodiscard]] bool is_smooth() const { return !below.empty() && below == above; }
};

/// Of one front at the end of one step.
struct FrontKSensitivities {
  std::vector<Sensitivity> by_parameter;
  std::vector<std::string> notes; ///< why some or all are not given
};

/// The word of a parameter in listings and decks: "LOAD", "FIT", "E", "A", "C".
std::string display_word(SensitivityParameter cause);

} // namespace spricka::results
