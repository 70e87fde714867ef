// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "growth/trajectory.hpp"
#include "life/load_interaction.hpp"
#include "life/spectrum.hpp"
#include "model/forward.hpp"

#include <optional>
#include <string>
#include <vector>

namespace spricka::analysis {

/// The rule of an entry of CrackGrowthSettings::interactions, with the law of the growth.
life::LoadInteraction make_load_interaction(const model::Model& model,
                                            const std::optional<std::size_t>& entry);

/// Passes of a spectrum whose cycles act on each other, over the stations of a growth: cycle by
/// cycle where K of all loads is a map, else, and where there are more cycles than can be followed,
/// by the growth of a settled pass at each station. Both must outlive it.
class PassCounter {
public:
  PassCounter(const life::CountedSpectrum& spectrum, const life::LoadInteraction& interaction)
      : spectrum_(spectrum), interaction_(interaction) {}

  /// Passes from the first station to each s of `places`, ascending and within the stations.
  [[nodiscard]] std::vector<double> passes_at(const std::vector<growth::SolvedStation>& stations,
                                              const std::vector<double>& places) const;
  /// The s after so many passes; empty: it lies behind the last station.
  [[nodiscard]] std::optional<double>
  extent_after_passes(const std::vector<growth::SolvedStation>& stations, double passes) const;
  /// Whether each cycle of so many passes, as passes_at() has found them, was followed.
  [[nodiscard]] bool has_followed_each_cycle(const std::vector<growth::SolvedStation>& stations,
                                             double passes) const;

private:
  [[nodiscard]] bool may_follow_cycles(const std::vector<growth::SolvedStation>& stations) const;
  [[nodiscard]] std::vector<growth::SolvedStation>
  with_settled_rates(std::vector<growth::SolvedStation> stations) const;

  const life::CountedSpectrum& spectrum_;
  const life::LoadInteraction& interaction_;
};

/// What a rule is, with all its constants and the plastic zone that it gives the largest K of the
/// first and the last station: "W1: Wheeler, ...".
std::string describe_interaction(const model::Model& model,
                                 const life::LoadInteraction& interaction,
                                 const std::vector<growth::SolvedStation>& stations);

} // namespace spricka::analysis
