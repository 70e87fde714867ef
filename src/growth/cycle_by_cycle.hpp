// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "growth/trajectory.hpp"
#include "life/load_interaction.hpp"
#include "life/spectrum.hpp"

#include <cstddef>
#include <optional>
#include <vector>

namespace spricka::growth {

/// A growth cycle by cycle over stations whose K is known for all loads of a spectrum
/// (TipStation::K_over_path): each cycle grows by K of its loads at the lengths it begins with, and
/// by what the tips remember (manual/theory/interaction.md). Between stations K of each load is
/// interpolated as GrowthTrajectory does; the arms of the tips follow the stations. Where K turns
/// within the loads the cycles are counted anew on K at the beginning of each pass.
class CycleByCycleGrowth {
public:
  /// stations [>= 2], s ascending. All must outlive it.
  CycleByCycleGrowth(const std::vector<SolvedStation>& stations,
                     const life::CountedSpectrum& spectrum);

  /// Passes from the first station to each s of `places`, ascending and within the stations;
  /// infinite behind a place where nothing grows any more. Empty: more than `most_cycles` would be
  /// needed.
  [[nodiscard]] std::optional<std::vector<double>>
  passes_at(const std::vector<double>& places, const life::LoadInteraction& interaction,
            double most_cycles) const;
  /// The s after so many passes; empty: it lies behind the last station or more than `most_cycles`
  /// would be needed.
  [[nodiscard]] std::optional<double> extent_after_passes(double passes,
                                                          const life::LoadInteraction& interaction,
                                                          double most_cycles) const;

private:
  const std::vector<SolvedStation>& stations_;
  const life::CountedSpectrum& spectrum_;
  double cycles_per_pass_ = 0.0;

  class KOfLoads;
  class Run;
};

} // namespace spricka::growth
