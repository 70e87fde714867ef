// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/steps/increment_state.hpp"

#include "analysis/steps/row_opening.hpp"
#include "model/model.hpp"

#include <algorithm>

#include <fmt/format.h>

namespace spricka::analysis {

IncrementState::IncrementState(const model::Model& model, const Discretisation& scene,
                               const std::vector<SubstructuredBody>& bodies,
                               MountOffsetMemory* memory)
    : scene_(scene), bodies_(bodies),
      factors_(initial_step_factors(model, scene.case_load.cols(), scene.contacts.size())),
      offset_(base::Vector::Zero(static_cast<Eigen::Index>(scene.table.size()))), history_(scene),
      memory_(memory) {
  if (memory_ != nullptr) {
    memory_->begin_new_length();
  }
}

bool IncrementState::mount(std::size_t contact, const base::Vector& u) {
  const bool declared = scene_.contacts[contact].gap.has_value();
  for (std::size_t r = scene_.table.first[contact]; r < scene_.table.first[contact + 1]; ++r) {
    const contact::ConstraintRow& row = scene_.contact_row(r);
    // Declared fits and slips count from the bodies as they are now, so that what these have moved
    // so far is taken off (contact.8); a measured gap is that of the deformed bodies and keeps it.
    const bool taken = row.tangential || declared;
    offset_[static_cast<Eigen::Index>(r)] =
        taken ? -row_opening(row, scene_.cracked.mesh.dim, u) : 0.0;
  }
  history_.begin(contact);
  closed_.clear(); // they say nothing of rows that are new
  return memory_ == nullptr || memory_->store_or_restore_offsets(
                                   scene_, contact, scene_.contacts[contact].mu > 0.0, offset_);
}

bool IncrementState::carry_out_actions(const model::Step& step, const base::Vector& u,
                                       base::OptionalFailure& trouble) {
  const MountChanges changes = apply_step_actions(step, factors_);
  for (const std::size_t contact : changes.mounted) {
    if (!mount(contact, u)) {
      trouble = base::OperationFailure{
          .kind = base::ProgramOutcome::not_solvable,
          .why = fmt::format("MOUNTED=FIRST: the surfaces of contact {} are meshed differently at "
                             "this length, so that what it took on at the first one cannot be kept",
                             scene_.contacts[contact].name),
          .span = step.span};
      return false;
    }
  }
  if (!changes.dismounted.empty()) {
    closed_.clear();
  }
  return true;
}

base::Vector IncrementState::prescribed_displacements() const {
  return scene_.case_displacement * factors_.case_factor;
}

contact::ContactSystem::IncrementProblem IncrementState::contact_problem() const {
  contact::ContactSystem::IncrementProblem d;
  const base::Vector fixed = prescribed_displacements();
  const int dim = scene_.cracked.mesh.dim;
  std::vector<double> gap;
  for (std::size_t c = 0; c < scene_.contacts.size(); ++c) {
    if (!factors_.mounted[c]) {
      continue;
    }
    const model::Contact& contact = scene_.contacts[c];
    for (std::size_t r = scene_.table.first[c]; r < scene_.table.first[c + 1]; ++r) {
      const contact::ConstraintRow& row = scene_.contact_row(r);
      d.rows.push_back(r);
      d.equality.push_back(contact.type == model::ContactType::bonded);
      // Prescribed displacements are no unknowns of condensed bodies: the gap has what they open.
      gap.push_back((contact.gap ? factors_.fit[c] : 1.0) * row.gap +
                    offset_[static_cast<Eigen::Index>(r)] + row_opening(row, dim, fixed));
      if (!closed_.empty()) {
        d.start.push_back(closed_[r]);
      }
    }
  }
  d.gap = Eigen::Map<const base::Vector>(gap.data(), static_cast<Eigen::Index>(gap.size()));
  for (const SubstructuredBody& body : bodies_) {
    if (!body.condensed) {
      continue;
    }
    d.load.emplace_back(body.external_load * factors_.case_factor);
    d.motion.emplace_back(body.is_uncondensed()
                              ? base::Vector(body.case_motion * factors_.case_factor)
                              : base::Vector());
  }
  // Sum of the applied forces: loads on rigid modes count as none by their share of it (solve.16).
  d.load_scale = (scene_.case_load * factors_.case_factor).lpNorm<1>();
  if (fixed.size() > 0 && !fixed.isZero(0.0)) {
    // Bodies that supports move are loaded by these: forces that no case has.
    double moved = 0.0;
    for (const base::Vector& load : d.load) {
      moved += load.lpNorm<1>();
    }
    d.load_scale = std::max(d.load_scale, moved);
  }
  history_.add_friction(d);
  return d;
}

// Where rows stand tangentially now: the slip of the next increment counts from here (contact.22).
void IncrementState::accept_solved_increment(
    const contact::ContactSystem& system, const contact::ContactSystem::IncrementProblem& problem,
    const contact::ContactSystem::IncrementSolution& solution) {
  history_.accept_increment(problem, solution);
  const base::Vector fixed = prescribed_displacements();
  for (const std::size_t row : problem.rows) {
    if (history_.is_friction_row(row)) {
      offset_[static_cast<Eigen::Index>(row)] =
          -system.row_opening(row, solution.u) -
          row_opening(scene_.contact_row(row), scene_.cracked.mesh.dim, fixed);
    }
  }
}

StepSolverState IncrementState::solver_state() const {
  return {factors_, offset_, closed_, history_.friction_state()};
}

void IncrementState::restore_state(const StepSolverState& place) {
  factors_ = place.factors;
  offset_ = place.offset;
  closed_ = place.closed;
  history_.restore_state(place.friction);
}

} // namespace spricka::analysis
