// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/steps/step_incrementation.hpp"

namespace spricka::analysis {

namespace {

// An increment with friction that does not converge is halved so often.
constexpr int most_halvings = 6;

} // namespace

void StepIncrementation::solve() {
  solution_ = system_.solve(problem_, settings_);
  iterations_ += solution_.contact.block_iterations;
  pivots_ += solution_.contact.pivots;
}

void StepIncrementation::solve_end(contact::ContactSystem::IncrementProblem problem) {
  problem_ = std::move(problem);
  solve();
  increments_ = 1;
}

std::optional<int> StepIncrementation::solve_increments(int increments) {
  increments_ = 0;
  reached_.clear();
  for (int k = 0; k < increments; ++k) {
    const double n = increments;
    if (!advance({k / n, (k + 1) / n}, 0)) {
      return k + 1;
    }
  }
  return std::nullopt;
}

// In a straight line from the last two increments: most points go on as they did.
solve::PredictedContactForces StepIncrementation::expected_at(double part) const {
  if (reached_.empty()) {
    return {};
  }
  const ReachedIncrement& last = reached_.back();
  const ReachedIncrement& before = reached_.front();
  const double way = last.at - before.at;
  const double further = way > 0.0 ? (part - last.at) / way : 0.0;
  return {last.forces.lambda + further * (last.forces.lambda - before.forces.lambda),
          last.forces.alpha + further * (last.forces.alpha - before.forces.alpha)};
}

bool StepIncrementation::advance(std::pair<double, double> part, int halvings) {
  state_.set_factors(interpolate_step_factors(from_, to_, part.second));
  problem_ = state_.contact_problem();
  problem_.expected = expected_at(part.second);
  solve();
  const solve::ContactSolution& s = solution_.contact;
  if (s.status == solve::ContactStatus::solved) {
    ++increments_;
    state_.accept_solved_increment(system_, problem_, solution_);
    reached_.push_back({part.second, {s.lambda, s.alpha}});
    if (reached_.size() > 2) {
      reached_.erase(reached_.begin());
    }
    if (seen_ != nullptr) {
      (*seen_)(problem_, solution_);
    }
    return true;
  }
  // Only what did not converge is halved: loads that nothing holds, and bonds that contradict each
  // other, would be met again.
  if (s.status != solve::ContactStatus::max_iterations || halvings == most_halvings) {
    return false;
  }
  const double middle = 0.5 * (part.first + part.second);
  return advance({part.first, middle}, halvings + 1) &&
         advance({middle, part.second}, halvings + 1);
}

} // namespace spricka::analysis
