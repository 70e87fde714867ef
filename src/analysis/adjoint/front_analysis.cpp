// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/adjoint/front_analysis.hpp"

#include <algorithm>
#include <cmath>

namespace spricka::analysis {

namespace {

// More columns gain little.
constexpr std::size_t most_steps_together = 4;

} // namespace

FrontErrorsAndSensitivities::FrontErrorsAndSensitivities(
    const model::Model& model, const Discretisation& scene,
    const std::vector<SubstructuredBody>& bodies, const KFunctionals& K)
    : scene_(scene), bodies_(bodies), K_(K), bars_(model, scene), sensitivities_(model, scene) {}

bool FrontErrorsAndSensitivities::begin_bars(const StepSolver& solver, const StepState& state,
                                             bool sensitivities, results::LoadStepResult& result,
                                             const ProcessorEndCallback& ended) {
  const ClosedContactRows rows = closed_contact_rows(solver, scene_);
  const auto system = std::make_shared<const FrozenContactSystem>(
      solver, scene_, bodies_,
      rows.rubs ? std::vector<bool>(rows.closed.size(), false) : rows.closed);
  const FrozenContactStep step{solver, state, rows, *system};
  unfinished_.push_back(bars_.begin(step, system, K_));
  if (!ended("ESTIMATE", "loads on cubic modes, edges of contact")) {
    return false;
  }
  if (!sensitivities) {
    return true;
  }
  sensitivities_.add_to_fronts(step, K_, result);
  return ended("SENSITIVITY", "loads, fits, moduli, axes");
}

// Factors of the closed rows, together no more than twice as large as the compliances of all rows.
bool FrontErrorsAndSensitivities::is_full() const {
  double size = 0.0;
  for (const UnfinishedFrontBars& step : unfinished_) {
    size += std::pow(static_cast<double>(std::ranges::count(step.load.closed, true)), 2.0);
  }
  return unfinished_.size() >= most_steps_together ||
         size > 2.0 * std::pow(static_cast<double>(scene_.table.size()), 2.0);
}

void FrontErrorsAndSensitivities::finish_bars(const std::vector<results::LoadStepResult*>& steps) {
  bars_.finish(unfinished_, K_, steps);
  unfinished_.clear();
}

} // namespace spricka::analysis
