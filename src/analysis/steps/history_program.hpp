// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "analysis/steps/step_factors.hpp"
#include "model/forward.hpp"

#include <cstddef>
#include <string>
#include <vector>

/// The loads that a crack grows by, in their order: with friction K depends on it.
namespace spricka::analysis {

/// Whether K of the growth depends on the order of loads: a law, and something that rubs.
bool depends_on_load_order(const model::Model& model);

/// Loads and fits that the history comes by; `increments` lead there from the place before, 0: as
/// many as the way along the load path takes.
struct LoadHistoryPoint {
  StepActionFactors factors;
  double t = 0.0; ///< place on the load path
  int increments = 0;
};

struct RepeatedLoadSegment {
  std::vector<LoadHistoryPoint> places;
  double count = 1.0; ///< times that it is gone through
  bool alone = false; ///< each time is a cycle that is counted by itself
};

/// A pass of the loads. Marks are the places of all legs, in order.
struct GrowthLoadHistory {
  std::size_t start = 0; ///< step behind which the history begins
  std::vector<RepeatedLoadSegment> legs;
  double per_unit = 1.0;    ///< increments for a unit of t
  std::size_t grow_at = 0;  ///< mark at which the crack grows: the largest load
  std::size_t smallest = 0; ///< mark of KMIN, where no spectrum is
  std::string none;         ///< why the loads cannot be repeated; empty: they can
};

/// From the card of the growth, the factors at the end of all steps, and into how many increments
/// each step was cut [step].
GrowthLoadHistory make_growth_load_history(const model::Model& model,
                                           const std::vector<StepActionFactors>& of_step,
                                           const std::vector<int>& increments);

} // namespace spricka::analysis
