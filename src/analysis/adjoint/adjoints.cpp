// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/adjoint/adjoints.hpp"

#include "analysis/scene/front_functionals.hpp"
#include "model/model.hpp"

#include <utility>

namespace spricka::analysis {

namespace {

// What K may feel of a motion that nothing holds, over all it feels: quadrature leaves 1e-7.
constexpr UnheldLoadLimit felt_motion{1e-4, "K depends on a motion that no closed contact holds"};

} // namespace

KAdjoints::KAdjoints(const model::Model& model, const Discretisation& scene,
                     const std::vector<SubstructuredBody>& bodies)
    : model_(model), scene_(scene), bodies_(bodies) {}

void KAdjoints::condense_rows() {
  const crack::KLayout layout = scene_.k_layout();
  base::Matrix nodal(K_rows(model_, scene_));
  for (std::size_t t = 0; t < layout.points(); ++t) {
    rows_.emplace_back(layout.columns(nodal, t));
  }
  by_force_ = K_by_forces(model_, scene_).transpose();
  condensed_ = condense_loads(scene_, bodies_, std::move(nodal));
}

std::vector<estimate::IntensityAdjoint>
KAdjoints::solve_closed_set(const FrozenContactSystem& system, const std::vector<bool>& closed) {
  if (rows_.empty()) {
    condense_rows();
  }
  const crack::KLayout layout = scene_.k_layout();
  // K has a term of the forces between faces, for which z leaves a gap there (sensitivity.13); w on
  // the closed rows by (sensitivity.3), z by (sensitivity.4).
  const FrozenContactResponse answer = system.solve_response(condensed_, by_force_, felt_motion);
  std::vector<estimate::IntensityAdjoint> out(rows_.size());
  for (std::size_t t = 0; t < rows_.size(); ++t) {
    out[t].why_not = answer.why_not;
    out[t].rows = rows_[t];
    out[t].by_force = layout.columns(by_force_, t);
    out[t].closed = closed;
    if (answer.why_not.empty()) {
      out[t].z = layout.columns(answer.u, t);
      out[t].w = layout.columns(answer.force, t);
    }
  }
  return out;
}

const std::vector<estimate::IntensityAdjoint>&
KAdjoints::solve_last_step(const StepSolver& solver) {
  const std::size_t count = scene_.cracked.fronts.size();
  const auto [closed, rubs] = closed_rows(solver, scene_);
  if (rubs) {
    held_.reset();
    last_.assign(count, {});
    for (estimate::IntensityAdjoint& adjoint : last_) {
      adjoint.why_not = depends_on_history;
    }
  } else if (count > 0 &&
             (last_.empty() || !last_.front().is_available() || last_.front().closed != closed)) {
    held_.emplace(solver, scene_, bodies_, closed);
    last_ = solve_closed_set(*held_, closed);
  }
  return last_;
}

} // namespace spricka::analysis
