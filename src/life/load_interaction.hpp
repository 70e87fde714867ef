// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "life/growth_law.hpp"
#include "life/newman_closure.hpp"
#include "life/rainflow.hpp"
#include "model/interaction_rules.hpp"

#include <limits>
#include <optional>
#include <vector>

namespace spricka::life {

/// What a tip remembers of the overload whose plastic zone it grows in.
struct OverloadMemory {
  double a = 0.0;        ///< length at the overload [length]
  double zone = 0.0;     ///< its plastic zone, ahead of there [length]
  double K_max = 0.0;    ///< of the overload [stress intensity]; 0: there was none
  double lowest_K = 0.0; ///< since then, that of the overload's own cycle included

  friend bool operator==(const OverloadMemory&, const OverloadMemory&) = default;
};

/// Lowest and highest of cycles; 0 and 0 of none.
LoadCycle extreme_loads(const std::vector<LoadCycle>& cycles);

/// Growth of a cycle behind others: each one that reaches the end of the plastic zone in memory or
/// farther takes the memory over and is not held back; the others grow less, by Wheeler,
/// Willenborg or Chang. With one opening level for all cycles nothing is remembered.
class LoadInteraction {
public:
  /// `interaction` empty: none. Chang wants Walker's law without a threshold, constant closure
  /// Paris' law of the effective delta K.
  LoadInteraction(std::optional<model::LoadInteractionDefinition> interaction, GrowthRateLaw law);

  /// da of one cycle [length] from a place whose length is place.a. `whole_pass`: smallest and
  /// largest K of the pass.
  double growth(double K_max, double K_min, const LoadCycle& whole_pass,
                const model::PlaceOnCrack& place, OverloadMemory& memory) const;
  /// da of a pass of cycles of K in their order [length] once it is like the one before: K stays
  /// that of the place.
  [[nodiscard]] double growth_of_settled_pass(const std::vector<LoadCycle>& cycles,
                                              model::PlaceOnCrack place) const;

  [[nodiscard]] const GrowthRateLaw& law() const { return law_; }
  [[nodiscard]] const std::optional<model::LoadInteractionDefinition>& definition() const {
    return interaction_;
  }
  /// The K_max in (interaction.4) below which a cycle of R = 0 does not grow [stress intensity].
  [[nodiscard]] double largest_K_without_growth() const { return threshold_; }
  /// Size of the plastic zone of a cycle [length].
  [[nodiscard]] double plastic_zone(double K_max) const;
  /// What part of K_required - K_max is taken off (interaction.4), (interaction.5); `ratio`: lowest
  /// K since the overload over the overload's.
  [[nodiscard]] double reduction_factor(double K_max, double ratio) const;

private:
  [[nodiscard]] double retarded(double K_max, double K_min, const model::PlaceOnCrack& place,
                                double zone, OverloadMemory& memory) const;
  [[nodiscard]] double unretarded(double K_max, double K_min,
                                  const model::PlaceOnCrack& place) const;
  [[nodiscard]] double chang_rate(double K_max, double K_min,
                                  const model::PlaceOnCrack& place) const;
  [[nodiscard]] double zone_end(const OverloadMemory& memory) const;
  [[nodiscard]] double shortened_zone(const OverloadMemory& memory) const;

  std::optional<model::LoadInteractionDefinition> interaction_;
  GrowthRateLaw law_;
  NewmanClosure closure_;
  double threshold_ = 0.0;
};

} // namespace spricka::life
