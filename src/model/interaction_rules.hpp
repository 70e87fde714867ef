// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/source.hpp"

#include <optional>
#include <string>

namespace spricka::model {

/// What a cycle grows behind a larger one; equations in manual/theory/interaction.md.
enum class InteractionRule {
  wheeler,         ///< (interaction.3)
  willenborg_1971, ///< (interaction.4) with phi = 1 and no K below 0
  willenborg,      ///< (interaction.4), generalised
  modified,        ///< (interaction.5), with underloads
  chang,           ///< (interaction.6), with Walker's law
  closure          ///< one opening level for all cycles
};

/// How cycles of a spectrum act on those that follow.
struct LoadInteractionDefinition {
  std::string name;
  InteractionRule rule = InteractionRule::wheeler;
  double zone_factor = 0.0;    ///< plastic zone over (K_max / yield stress)^2
  std::string zone_name;       ///< of zone_factor; empty: the deck gives the number
  double yield_stress = 0.0;   ///< [stress]
  double exponent = 0.0;       ///< Wheeler
  double shut_off_ratio = 0.0; ///< of an overload that stops the growth; Willenborg, Chang
  /// The K_max below which a cycle of R = 0 does not grow [stress intensity]; empty: the law's.
  std::optional<double> threshold;
  bool negative_minimum_is_zero = false; ///< of the effective K, Willenborg
  double underload_factor = 0.0;         ///< phi_0, modified
  double threshold_slope = 0.0;          ///< over R, Chang
  double negative_exponent = 0.0;        ///< q, Chang
  double largest_ratio = 0.0;            ///< R that counts at most, Chang
  double smallest_ratio = 0.0;           ///< R that counts at least, Chang
  double constraint = 2.0;               ///< Newman's alpha, closure
  double stress_ratio = 0.3;             ///< largest stress over flow stress, closure
  base::SourceSpan span;
};

} // namespace spricka::model
