// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "analysis/steps/increment_state.hpp"
#include "contact/system.hpp"
#include "solve/contact_qp.hpp"

#include <functional>
#include <optional>
#include <utility>
#include <vector>

namespace spricka::analysis {

/// Is shown each solved increment.
using SeenIncrement = std::function<void(const contact::ContactSystem::IncrementProblem&,
                                         const contact::ContactSystem::IncrementSolution&)>;

/// Loads and fits on a straight line from where a state stands to other factors, in increments.
class StepIncrementation {
public:
  StepIncrementation(const contact::ContactSystem& system, const solve::ContactSettings& settings,
                     IncrementState& state, StepActionFactors from, StepActionFactors to,
                     const SeenIncrement* seen = nullptr)
      : system_(system), settings_(settings), state_(state), from_(std::move(from)),
        to_(std::move(to)), seen_(seen) {}

  /// The problem of the end at once, where nothing rubs: nothing is remembered.
  void solve_end(contact::ContactSystem::IncrementProblem problem);
  /// In so many equal increments, each halved where it does not converge. The number of the one
  /// that has no solution; empty: the end is reached.
  std::optional<int> solve_increments(int increments);

  /// Of the last increment.
  [[nodiscard]] const contact::ContactSystem::IncrementProblem& problem() const { return problem_; }
  [[nodiscard]] const contact::ContactSystem::IncrementSolution& solution() const {
    return solution_;
  }
  [[nodiscard]] contact::ContactSystem::IncrementSolution take_solution() {
    return std::move(solution_);
  }
  [[nodiscard]] int increments() const { return increments_; } ///< to the end that was reached last
  [[nodiscard]] int iterations() const { return iterations_; } ///< of all
  [[nodiscard]] int pivots() const { return pivots_; }

private:
  struct ReachedIncrement {
    double at = 0.0; ///< part of the step
    solve::PredictedContactForces forces;
  };
  void solve();
  /// One increment between two parts of the step, halved where it does not converge.
  bool advance(std::pair<double, double> part, int halvings);
  [[nodiscard]] solve::PredictedContactForces expected_at(double part) const;

  const contact::ContactSystem& system_;
  solve::ContactSettings settings_;
  IncrementState& state_;
  StepActionFactors from_, to_;
  const SeenIncrement* seen_;
  contact::ContactSystem::IncrementProblem problem_;
  contact::ContactSystem::IncrementSolution solution_;
  int increments_ = 0, iterations_ = 0, pivots_ = 0;
  std::vector<ReachedIncrement> reached_; ///< the last two
};

} // namespace spricka::analysis
