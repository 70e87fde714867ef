// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/adjoint/frozen_change.hpp"

#include <algorithm>
#include <utility>

namespace spricka::analysis {

namespace {

// Loads on motions that nothing holds, over the largest load: more than round-off.
constexpr double unheld_load = 1e-6;

} // namespace

FrozenContactSystem::FrozenContactSystem(const StepSolver& solver, const Discretisation& scene,
                                         const std::vector<SubstructuredBody>& bodies,
                                         const std::vector<bool>& closed)
    : solver_(solver), scene_(scene), bodies_(bodies), held_(constrain_rows(solver, closed)) {}

FrozenContactResponse FrozenContactSystem::solve_response(base::Matrix loads,
                                                          const base::Matrix& gaps) const {
  FrozenContactResponse out;
  if (held_ && !held_->is_consistent()) {
    out.why_not = "the closed contacts contradict each other";
    return out;
  }
  const Eigen::Index columns = loads.cols();
  scene_.ties->transfer_to_masters(loads);
  std::vector<CondensedLoad> condensed;
  for (const SubstructuredBody& body : bodies_) {
    condensed.push_back(condense_load(body, *scene_.ties, loads));
  }
  std::vector<base::Matrix> external(bodies_.size());
  out.force = base::Matrix::Zero(static_cast<Eigen::Index>(scene_.table.size()), columns);
  if (held_) {
    std::vector<base::Matrix> load;
    double size = 0.0;
    for (const std::size_t b : solver_.condensed_bodies()) {
      load.push_back(condensed[b].external);
      size = std::max(size, load.back().size() > 0 ? load.back().cwiseAbs().maxCoeff() : 0.0);
    }
    out.free = contact::unconstrained_response(*solver_.contact_system(), load);
    const contact::FixedActiveSet::ActiveSetResponse found = held_->solve_response(
        gaps.cols() > 0 ? base::Matrix(out.free.opening + gaps) : out.free.opening,
        out.free.on_mode);
    if (found.left_over > unheld_load * size) {
      out.why_not = "no closed contact holds a body against it";
      return out;
    }
    out.force = found.force;
    std::vector<base::Matrix> u = held_->displacement(load, found);
    for (std::size_t i = 0; i < u.size(); ++i) {
      external[solver_.condensed_bodies()[i]] = std::move(u[i]);
    }
  }
  out.u = base::Matrix::Zero(loads.rows(), columns);
  for (std::size_t b = 0; b < bodies_.size(); ++b) {
    // A change of displacements: constants of ties have no part in it.
    recover_body(bodies_[b], external[b], condensed[b], 0.0, out.u);
  }
  return out;
}

} // namespace spricka::analysis
