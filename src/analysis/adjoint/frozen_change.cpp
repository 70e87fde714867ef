// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/adjoint/frozen_change.hpp"

#include <algorithm>
#include <utility>

namespace spricka::analysis {

namespace {

// Zero loads in the shape that condense_load() gives: a body that no K feels needs no half solve.
CondensedLoad no_load(const SubstructuredBody& body, Eigen::Index columns) {
  CondensedLoad load;
  load.external = base::Matrix::Zero(body.contact_unknown_count(), columns);
  if (body.is_uncondensed()) {
    return load;
  }
  load.region = base::Matrix::Zero(body.region.map.size(), columns);
  for (const std::unique_ptr<Substructure>& part : body.parts) {
    load.part.emplace_back(base::Matrix::Zero(part->map.size(), columns));
  }
  return load;
}

bool touches(const fe::Body& body, int dim, const base::Matrix& nodal) {
  return std::ranges::any_of(body.nodes, [&](base::NodeId n) {
    return (nodal.middleRows(static_cast<Eigen::Index>(n.index()) * dim, dim).array() != 0.0).any();
  });
}

constexpr const char* contradiction = "the closed contacts contradict each other";

double largest_entry(const std::vector<base::Matrix>& loads) {
  double size = 0.0;
  for (const base::Matrix& load : loads) {
    size = std::max(size, load.size() > 0 ? load.cwiseAbs().maxCoeff() : 0.0);
  }
  return size;
}

// The closed rows of the table [row] held; null where no body has externals.
std::unique_ptr<contact::FixedActiveSet> constrain_rows(const StepSolver& solver,
                                                        const std::vector<bool>& closed) {
  if (solver.contact_system() == nullptr) {
    return nullptr;
  }
  std::vector<std::size_t> rows;
  for (std::size_t r = 0; r < closed.size(); ++r) {
    if (closed[r]) {
      rows.push_back(r);
    }
  }
  return std::make_unique<contact::FixedActiveSet>(*solver.contact_system(), std::move(rows));
}

} // namespace

ClosedContactRows closed_contact_rows(const StepSolver& solver, const Discretisation& scene) {
  ClosedContactRows rows;
  rows.closed.assign(scene.table.size(), false);
  if (solver.contact_system() != nullptr) {
    const contact::ContactSystem::IncrementProblem problem = solver.contact_problem();
    rows.rubs = !problem.friction.empty();
    for (std::size_t i = 0; i < problem.rows.size(); ++i) {
      // A next problem would begin with the rows that the last one ended with.
      rows.closed[problem.rows[i]] = problem.start.empty() ? problem.equality[i] : problem.start[i];
    }
  }
  return rows;
}

CondensedLoads condense_loads(const Discretisation& scene,
                              const std::vector<SubstructuredBody>& bodies, base::Matrix loads) {
  CondensedLoads condensed;
  condensed.freedoms = loads.rows();
  condensed.columns = loads.cols();
  scene.ties->transfer_forces_to_masters(loads);
  for (const SubstructuredBody& body : bodies) {
    condensed.of_body.push_back(touches(body.body, scene.cracked.mesh.dim, loads)
                                    ? condense_load(body, *scene.ties, loads)
                                    : no_load(body, loads.cols()));
  }
  return condensed;
}

FrozenContactSystem::FrozenContactSystem(const StepSolver& solver, const Discretisation& scene,
                                         const std::vector<SubstructuredBody>& bodies,
                                         const std::vector<bool>& closed)
    : solver_(solver), scene_(scene), bodies_(bodies), held_(constrain_rows(solver, closed)) {}

std::vector<base::Matrix> FrozenContactSystem::external_loads(const CondensedLoads& loads) const {
  std::vector<base::Matrix> external;
  for (const std::size_t b : solver_.condensed_body_indices()) {
    external.push_back(loads.of_body[b].external);
  }
  return external;
}

std::string FrozenContactSystem::why_no_response(base::Matrix loads) const {
  if (!held_) {
    return {};
  }
  if (!held_->is_consistent()) {
    return contradiction;
  }
  const std::vector<base::Matrix> external =
      external_loads(condense_loads(scene_, bodies_, std::move(loads)));
  const base::Matrix on_mode = contact::loads_on_rigid_modes(*solver_.contact_system(), external);
  const UnheldLoadLimit limit;
  return held_->unheld_load(on_mode) > limit.part * largest_entry(external) ? limit.why_not : "";
}

FrozenContactResponse FrozenContactSystem::solve_response(base::Matrix loads,
                                                          const base::Matrix& gaps) const {
  CondensedLoads condensed = condense_loads(scene_, bodies_, std::move(loads));
  FrozenContactResponse out = solve_response(condensed, gaps, {});
  out.free = std::move(condensed.free);
  return out;
}

void FrozenContactSystem::respond_without_contact(CondensedLoads& loads) const {
  if (loads.free.u.empty()) {
    loads.external = external_loads(loads);
    loads.free = contact::response_without_contact(*solver_.contact_system(), loads.external);
  }
}

base::Matrix
FrozenContactSystem::displacements(const CondensedLoads& loads,
                                   const contact::FixedActiveSet::ActiveSetResponse* answer) const {
  std::vector<base::Matrix> external(bodies_.size());
  if (answer != nullptr) {
    std::vector<base::Matrix> u =
        contact::external_displacements(*solver_.contact_system(), loads.free, *answer);
    for (std::size_t i = 0; i < u.size(); ++i) {
      external[solver_.condensed_body_indices()[i]] = std::move(u[i]);
    }
  }
  base::Matrix u = base::Matrix::Zero(loads.freedoms, loads.columns);
  for (std::size_t b = 0; b < bodies_.size(); ++b) {
    // A change of displacements: constants of ties have no part in it.
    recover_body_displacements(bodies_[b], external[b], loads.of_body[b], 0.0, u);
  }
  return u;
}

FrozenContactResponse FrozenContactSystem::solve_response(CondensedLoads& loads,
                                                          const base::Matrix& gaps,
                                                          const UnheldLoadLimit& unheld) const {
  FrozenContactResponse out;
  if (!held_) {
    out.force = base::Matrix::Zero(static_cast<Eigen::Index>(scene_.table.size()), loads.columns);
    out.u = displacements(loads, nullptr);
    return out;
  }
  if (!held_->is_consistent()) {
    out.why_not = contradiction;
    return out;
  }
  respond_without_contact(loads);
  const contact::FixedActiveSet::ActiveSetResponse found = held_->solve_response(
      gaps.cols() > 0 ? base::Matrix(loads.free.opening + gaps) : loads.free.opening,
      loads.free.on_mode);
  if (found.left_over > unheld.part * largest_entry(loads.external)) {
    out.why_not = unheld.why_not;
    return out;
  }
  out.u = displacements(loads, &found);
  out.force = found.force;
  return out;
}

// What forces of rows open is known from the compliances of the rows: one back-substitution gives
// the displacements by all forces.
FrozenContactResponse FrozenContactSystem::solve_row_response(const base::Matrix& gaps,
                                                              const base::Matrix& forces) const {
  FrozenContactResponse out;
  if (!held_->is_consistent()) {
    out.why_not = contradiction;
    return out;
  }
  const contact::ContactSystem& system = *solver_.contact_system();
  CondensedLoads none = condense_loads(
      scene_, bodies_,
      base::Matrix::Zero(scene_.cracked.mesh.dim *
                             static_cast<Eigen::Index>(scene_.cracked.mesh.node_count()),
                         forces.cols()));
  none.external = external_loads(none);
  none.free.u = none.external;
  contact::FixedActiveSet::ActiveSetResponse found =
      held_->solve_response(gaps + contact::openings_by_forces(system, forces),
                            system.openings_by_rigid_modes().transpose() * forces);
  for (Eigen::Index row = 0; row < forces.rows(); ++row) {
    system.add_row_force(static_cast<std::size_t>(row), forces.row(row), none.external);
  }
  const UnheldLoadLimit unheld;
  if (found.left_over > unheld.part * largest_entry(none.external)) {
    out.why_not = unheld.why_not;
    return out;
  }
  out.force = found.force;
  found.force += forces;
  out.u = displacements(none, &found);
  return out;
}

FrozenStepResponses
FrozenContactSystem::solve_responses(const std::vector<const FrozenContactSystem*>& steps,
                                     base::Matrix loads) {
  const FrozenContactSystem& any = *steps.front();
  const auto count = static_cast<Eigen::Index>(steps.size());
  CondensedLoads condensed = condense_loads(any.scene_, any.bodies_, std::move(loads));
  FrozenStepResponses out;
  out.failed.assign(steps.size(), false);
  out.force = base::Matrix::Zero(static_cast<Eigen::Index>(any.scene_.table.size()), count);
  if (!any.held_) {
    out.u = any.displacements(condensed, nullptr);
    return out;
  }
  any.respond_without_contact(condensed);
  const contact::ResponseWithoutContact& free = condensed.free;
  contact::FixedActiveSet::ActiveSetResponse all;
  all.force = base::Matrix::Zero(free.opening.rows(), count);
  all.mode = base::Matrix::Zero(free.on_mode.rows(), count);
  const UnheldLoadLimit unheld;
  for (Eigen::Index s = 0; s < count; ++s) {
    const contact::FixedActiveSet& held = *steps[static_cast<std::size_t>(s)]->held_;
    const bool consistent = held.is_consistent();
    contact::FixedActiveSet::ActiveSetResponse found;
    if (consistent) {
      found = held.solve_response(free.opening.col(s), free.on_mode.col(s));
    }
    double load = 0.0;
    for (const base::Matrix& external : condensed.external) {
      load = std::max(load, external.size() > 0 ? external.col(s).cwiseAbs().maxCoeff() : 0.0);
    }
    if (!consistent || found.left_over > unheld.part * load) {
      out.failed[static_cast<std::size_t>(s)] = true;
      continue;
    }
    all.force.col(s) = found.force;
    all.mode.col(s) = found.mode;
  }
  out.u = any.displacements(condensed, &all);
  out.force = all.force;
  return out;
}

} // namespace spricka::analysis
