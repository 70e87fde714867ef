// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/piecewise_linear.hpp"
#include "life/growth_law.hpp"
#include "life/law_use_counter.hpp"
#include "life/rainflow.hpp"
#include "model/steps.hpp"

#include <cstdint>
#include <utility>
#include <vector>

namespace spricka::life {

/// A pass of variable load along a load path: loads are places t on it. Counted and sorted once;
/// the growth of a pass is then one walk over the map K(t) of a crack length and one rate for each
/// different cycle. Loads outside the knots of a map give what is not a number: nothing is
/// extrapolated. The order of cycles does not matter (no interaction: manual/theory/life.md).
class CountedSpectrum {
public:
  /// Blocks: cycles as they are counted.
  static CountedSpectrum from_cycles(std::vector<LoadCycle> cycles);
  /// A history, counted by rainflow; `repeated`: the end of a pass leads to its start.
  static CountedSpectrum from_sequence(std::vector<double> history, bool repeated = true);
  /// A history that repeats, of which each valley counts with the peak behind it.
  static CountedSpectrum from_pairs(std::vector<double> history);
  /// Of a card, as it says how cycles are counted.
  static CountedSpectrum from_definition(const model::SpectrumDefinition& spectrum);

  /// Growth of one pass, da [length], at a fixed length of the crack whose K is K1(t). Where K1
  /// rises or falls all the way between the lowest and the highest load, cycles of t are cycles of
  /// K; else the history is counted again on K (`requires_counting_on_K`). Its cycles are added to
  /// `use`, if given.
  [[nodiscard]] double growth_per_pass(const GrowthRateLaw& law, const base::PiecewiseLinear& K1,
                                       const model::PlaceOnCrack& place = {},
                                       LawUseCounter* use = nullptr) const;
  /// The cycles of a pass as K, of which growth_per_pass() is the sum.
  [[nodiscard]] std::vector<LoadCycle> cycles_as_K(const base::PiecewiseLinear& K1) const;
  /// The cycles of a pass of a card, as places t, in their order.
  [[nodiscard]] const std::vector<LoadCycle>& cycles_in_order() const { return in_order_; }
  /// The same as K: counted on K where that turns within the loads, which is not a number outside
  /// the knots.
  [[nodiscard]] std::vector<LoadCycle> cycles_in_order_as_K(const base::PiecewiseLinear& K1) const;
  /// Growth of each of cycles() in a pass, which add up to growth_per_pass(); empty where K1 turns
  /// within the loads, or ends before.
  [[nodiscard]] std::vector<double> growth_by_cycle(const GrowthRateLaw& law,
                                                    const base::PiecewiseLinear& K1,
                                                    const model::PlaceOnCrack& place = {}) const;
  /// Whether `growth` counts on K for this map: K1 turns within the loads.
  [[nodiscard]] bool requires_counting_on_K(const base::PiecewiseLinear& K1) const;
  /// Smallest and largest K of a pass.
  [[nodiscard]] std::pair<double, double> extreme_K(const base::PiecewiseLinear& K1) const;

  [[nodiscard]] double lowest_load() const { return levels_.front(); }
  [[nodiscard]] double highest_load() const { return levels_.back(); }
  [[nodiscard]] double cycles_per_pass() const; ///< cycles of a pass, halves included
  /// The different cycles, sorted by low, then high load.
  [[nodiscard]] std::vector<LoadCycle> cycles() const;

private:
  struct LoadLevelCycle {
    std::uint32_t low, high; ///< levels
    double count;
  };
  explicit CountedSpectrum(const std::vector<LoadCycle>& counted);
  CountedSpectrum(std::vector<LoadCycle> counted, std::vector<double> history, bool repeated);
  [[nodiscard]] bool within(const base::PiecewiseLinear& K1) const;
  [[nodiscard]] std::vector<LoadCycle> cycles_of_K(const base::PiecewiseLinear& K1) const;
  /// Calls visit(low, high, count) for the cycles as K; all loads lie within K1.
  template <class Visit>
  void visit_cycles_as_K(const base::PiecewiseLinear& K1, const Visit& visit) const;

  std::vector<double> levels_; ///< different loads, ascending
  std::vector<LoadLevelCycle> cycles_;
  std::vector<LoadCycle> in_order_;
  std::vector<double> history_; ///< of a sequence: its turning points
  bool repeated_ = true;
  model::CycleCounting counting_ = model::CycleCounting::rainflow;
};

} // namespace spricka::life
