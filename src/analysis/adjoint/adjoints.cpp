// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/adjoint/adjoints.hpp"

#include "model/model.hpp"

#include <utility>

namespace spricka::analysis {

namespace {

// What K may feel of a motion that nothing holds, over all it feels: quadrature leaves 1e-7.
constexpr UnheldLoadLimit felt_motion{1e-4, "K depends on a motion that no closed contact holds"};

} // namespace

IntensityAdjointSolver::IntensityAdjointSolver(const Discretisation& scene,
                                               const std::vector<SubstructuredBody>& bodies,
                                               const KFunctionals& K)
    : scene_(scene), bodies_(bodies), K_(K) {}

StressIntensityAdjoints
IntensityAdjointSolver::solve_with_closed_rows(const FrozenContactSystem& system,
                                               const std::vector<bool>& closed) {
  if (rows_.size() == 0) {
    rows_ = K_.of_displacements();
    by_force_ = K_.of_contact_forces().transpose();
    condensed_ = condense_loads(scene_, bodies_, rows_);
  }
  // K has a term of the forces between faces, for which z leaves a gap there (sensitivity.13); w on
  // the closed rows by (sensitivity.3), z by (sensitivity.4).
  FrozenContactResponse answer = system.solve_response(condensed_, by_force_, felt_motion);
  return {.why_not = std::move(answer.why_not),
          .rows = rows_,
          .by_force = by_force_,
          .z = std::move(answer.u),
          .w = std::move(answer.force),
          .closed = closed};
}

const StressIntensityAdjoints&
IntensityAdjointSolver::solve_adjoint_of_last_step(const StepSolver& solver) {
  const auto [closed, rubs] = closed_contact_rows(solver, scene_);
  if (rubs) {
    held_.reset();
    last_.emplace();
    last_->why_not = depends_on_history;
  } else if (!last_ || !last_->is_available() || last_->closed != closed) {
    held_.emplace(solver, scene_, bodies_, closed);
    last_ = solve_with_closed_rows(*held_, closed);
  }
  return *last_;
}

} // namespace spricka::analysis
