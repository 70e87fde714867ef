// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/steps/step_solver.hpp"

#include "analysis/scene/sliding_contacts.hpp"
#include "analysis/steps/far_motion.hpp"
#include "analysis/steps/held_surfaces.hpp"
#include "analysis/steps/missing_contact.hpp"
#include "analysis/steps/nodal_forces.hpp"
#include "analysis/steps/resting_forces.hpp"
#include "analysis/steps/rigid_motion.hpp"
#include "analysis/steps/round_gaps.hpp"
#include "analysis/steps/row_opening.hpp"
#include "base/dense_solve.hpp"
#include "model/model.hpp"
#include "solve/mode_split.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include <fmt/format.h>

namespace spricka::analysis {

namespace {

// Forces left over at free freedoms above this share of the force scale are not an answer.
constexpr double worst_imbalance = 1e-6;

} // namespace

StepSolver::StepSolver(const model::Model& model, const Discretisation& scene,
                       const std::vector<SubstructuredBody>& bodies, MountOffsetMemory* memory,
                       ContactMemory* contact)
    : model_(model), scene_(scene), bodies_(bodies),
      factors_(initial_step_factors(model, scene.case_load.cols(), scene.contacts.size())),
      offset_(base::Vector::Zero(static_cast<Eigen::Index>(scene.table.size()))),
      u_(base::Vector::Zero(static_cast<Eigen::Index>(scene.cracked.mesh.node_count()) *
                            scene.cracked.mesh.dim)),
      history_(scene), memory_(memory) {
  if (memory_ != nullptr) {
    memory_->restart();
  }
  std::vector<const contact::CondensedBody*> condensed;
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    if (bodies[b].condensed) {
      condensed.push_back(bodies[b].condensed.get());
      condensed_.push_back(b);
    }
  }
  if (!condensed.empty()) {
    system_.emplace(std::move(condensed), scene.reduced_contact_rows(), scene.cracked.mesh.dim,
                    static_cast<std::size_t>(u_.size()), pressing_contact_surfaces(scene),
                    contact == nullptr ? contact::PersistentRowSet{}
                                       : contact->find_persistent_rows(scene, bodies, condensed_));
  }
}

bool StepSolver::mount(std::size_t contact) {
  const bool declared = scene_.contacts[contact].gap.has_value();
  for (std::size_t r = scene_.table.first[contact]; r < scene_.table.first[contact + 1]; ++r) {
    const contact::ConstraintRow& row = scene_.contact_row(r);
    // Declared fits and slips count from the bodies as they are now, so that what these have moved
    // so far is taken off (contact.8); a measured gap is that of the deformed bodies and keeps it.
    const bool taken = row.tangential || declared;
    offset_[static_cast<Eigen::Index>(r)] =
        taken ? -row_opening(row, scene_.cracked.mesh.dim, u_) : 0.0;
  }
  history_.begin(contact);
  closed_.clear(); // they say nothing of rows that are new
  return memory_ == nullptr || memory_->store_or_restore_offsets(
                                   scene_, contact, scene_.contacts[contact].mu > 0.0, offset_);
}

bool StepSolver::act(const model::Step& step, base::OptionalFailure& trouble) {
  const MountChanges changes = apply_step_actions(step, factors_);
  for (const std::size_t contact : changes.mounted) {
    if (!mount(contact)) {
      trouble = base::OperationFailure{
          .kind = base::Outcome::not_solvable,
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

base::Vector StepSolver::prescribed() const {
  return scene_.case_displacement * factors_.case_factor;
}

contact::ContactSystem::IncrementProblem StepSolver::contact_problem() const {
  contact::ContactSystem::IncrementProblem d;
  const base::Vector fixed = prescribed();
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
  for (const std::size_t b : condensed_) {
    d.load.emplace_back(bodies_[b].external_load * factors_.case_factor);
    d.motion.emplace_back(bodies_[b].is_uncondensed()
                              ? base::Vector(bodies_[b].case_motion * factors_.case_factor)
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

base::Vector StepSolver::gap_without_fits_and_loads(const std::vector<std::size_t>& rows) const {
  base::Vector rest(static_cast<Eigen::Index>(rows.size()));
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const std::size_t r = rows[i];
    const auto c = scene_.table.contact_index(r);
    const base::ContactId contact(c);
    // A declared gap that no step names has the factor 1 on all of the path: nothing scales it.
    const bool scaled = scene_.contacts[c].gap && is_fit_set_by_steps(model_, contact);
    rest[static_cast<Eigen::Index>(i)] =
        offset_[static_cast<Eigen::Index>(r)] + (scaled ? 0.0 : scene_.contact_row(r).gap);
  }
  return rest;
}

std::string StepSolver::unsupported_motion(const base::Vector& mode, bool slides) const {
  Eigen::Index most = 0;
  mode.cwiseAbs().maxCoeff(&most);
  const std::size_t at = system_->body_of_mode(most);
  const SubstructuredBody& body = bodies_[condensed_[at]];
  const Eigen::Index first = system_->first_mode(at);
  // The condensed body's orthonormal modes are combinations of the free rigid modes: the same
  // combination on all nodes tells which way it goes.
  const std::vector<std::int32_t>& freedom = body.condensed->freedom();
  base::Matrix at_externals(static_cast<Eigen::Index>(freedom.size()),
                            body.free_rigid_modes.cols());
  for (std::size_t i = 0; i < freedom.size(); ++i) {
    at_externals.row(static_cast<Eigen::Index>(i)) = body.free_rigid_modes.row(freedom[i]);
  }
  const base::Vector shape =
      body.condensed->modes() * mode.segment(first, body.condensed->modes().cols());
  const base::Vector mix = base::least_squares(at_externals, shape);
  return fmt::format(
      "body {} {}: {}{}", body.name,
      slides ? "slides, friction does not hold it" : "is loaded but not held",
      describe_rigid_motion(scene_.cracked.mesh, body.body, body.free_rigid_modes * mix),
      slides ? "" : explain_missing_contact(model_, scene_, bodies_, condensed_[at]));
}

base::OptionalFailure
StepSolver::trouble_of(const contact::ContactSystem::IncrementSolution& solution) const {
  const solve::ContactSolution& s = solution.contact;
  switch (s.status) {
  case solve::ContactStatus::solved:
    break;
  case solve::ContactStatus::unheld_mode:
    return base::OperationFailure{.kind = base::Outcome::not_solvable,
                                  .why = unsupported_motion(s.unheld, solution.slides)};
  case solve::ContactStatus::inconsistent:
    return base::OperationFailure{
        .kind = base::Outcome::not_solvable,
        .why = "bonded contacts, supports and prescribed displacements contradict each other"};
  case solve::ContactStatus::max_iterations:
    return base::OperationFailure{
        .kind = base::Outcome::not_converged,
        .why = fmt::format("the contact solution did not end ({} iterations, {} pivots)",
                           s.block_iterations, s.pivots)};
  }
  return std::nullopt;
}

bool StepSolver::accept(const contact::ContactSystem::IncrementSolution& solution,
                        const contact::ContactSystem::IncrementProblem& problem, StepState& state,
                        base::OptionalFailure& trouble) {
  const solve::ContactSolution& s = solution.contact;
  if (base::OptionalFailure none = trouble_of(solution)) {
    trouble = std::move(none);
    return false;
  }
  if (base::OptionalFailure far = find_excessive_rigid_motion(
          scene_, bodies_, {*system_, condensed_, problem, solution}, prescribed())) {
    trouble = std::move(far);
    return false;
  }
  if (s.resting_modes > 0) {
    state.notes.push_back(results::note(
        fmt::format("{} rigid mode(s) that no contact touches and nothing loads stay at rest",
                    s.resting_modes)));
  }
  if (s.left_over > solve::rest_load) {
    state.notes.push_back(
        results::note(fmt::format("{:.1e} of the load acts on motions that no contact touches "
                                  "(such as its moment about the axis of a meshed round "
                                  "body) and is left over",
                                  s.left_over)));
  }
  if (s.redundant > 0) {
    state.notes.push_back(
        results::note(fmt::format("{} redundant contact row(s) left out", s.redundant)));
  }
  closed_.assign(scene_.table.size(), true);
  for (std::size_t i = 0; i < problem.rows.size(); ++i) {
    const std::size_t row = problem.rows[i];
    const auto c = scene_.table.contact_index(row);
    const std::size_t local = row - scene_.table.first[c];
    state.pair_lambda[c][static_cast<Eigen::Index>(local)] = s.lambda[static_cast<Eigen::Index>(i)];
    if (local < scene_.pairs[c].normal.size()) {
      state.pair_gap[c][static_cast<Eigen::Index>(local)] = s.gap[static_cast<Eigen::Index>(i)];
      state.pair_closed[c][local] = s.closed[i];
    }
    closed_[row] = s.closed[i];
  }
  state.resting = sliding_mode_residual_force(bodies_, condensed_, solution, u_.size());
  for (std::size_t c = 0; c < scene_.pairs.size(); ++c) {
    state.friction.push_back(history_.pair_friction(c));
  }
  warn_of_facet_gaps(scene_, *system_, problem, solution, state.notes);
  return true;
}

void StepSolver::adopt_earlier_step(const model::Step& step, const base::Vector& u,
                                    const std::vector<bool>& closed) {
  apply_step_actions(step, factors_);
  u_ = u;
  closed_ = closed;
}

StepState StepSolver::begin_state() const {
  StepState state;
  state.case_factor = factors_.case_factor;
  state.mounted = factors_.mounted;
  if (scene_.case_temperature.size() > 0) {
    state.temperature = scene_.case_temperature * factors_.case_factor;
  }
  for (std::size_t c = 0; c < scene_.pairs.size(); ++c) {
    const std::size_t rows = scene_.table.first[c + 1] - scene_.table.first[c];
    const std::size_t normal = scene_.pairs[c].normal.size();
    state.pair_lambda.emplace_back(base::Vector::Zero(static_cast<Eigen::Index>(rows)));
    state.pair_gap.emplace_back(base::Vector::Zero(static_cast<Eigen::Index>(normal)));
    state.pair_closed.emplace_back(normal, false);
  }
  // Bodies are recovered into this vector: free freedoms are overwritten, prescribed ones stay.
  state.u = prescribed();
  return state;
}

bool StepSolver::complete(std::vector<base::Vector> external, StepState& state,
                          base::OptionalFailure& trouble) const {
  std::vector<base::Vector> of_body(bodies_.size());
  for (std::size_t i = 0; i < external.size(); ++i) {
    of_body[condensed_[i]] = std::move(external[i]);
  }
  for (std::size_t b = 0; b < bodies_.size(); ++b) {
    recover_body(bodies_[b], of_body[b], factors_.case_factor, state.u);
  }
  add_nodal_forces(model_, scene_, factors_.case_factor, state);
  if (state.imbalance <= worst_imbalance) {
    return true;
  }
  trouble = base::OperationFailure{
      .kind = base::Outcome::not_converged,
      .why = fmt::format("the solution is not in equilibrium: {:.1e} of the load is left over (the "
                         "stiffness is close to singular)",
                         state.imbalance)};
  return false;
}

std::optional<StepState> StepSolver::solve(const model::Step& step,
                                           base::OptionalFailure& trouble) {
  const StepActionFactors before = factors_;
  if (!act(step, trouble)) {
    return std::nullopt;
  }
  StepState state = begin_state();
  std::vector<base::Vector> external;
  if (system_) {
    std::optional<contact::ContactSystem::IncrementSolution> solution =
        walk(before, step, state, trouble);
    if (!solution) {
      trouble->span = step.span;
      return std::nullopt;
    }
    external = std::move(solution->u);
  }
  if (!complete(std::move(external), state, trouble)) {
    trouble->span = step.span;
    return std::nullopt;
  }
  if (scene_.cracked.mesh.dim == 2) {
    std::vector<bool> pressed;
    for (const base::Vector& lambda : state.pair_lambda) {
      pressed.push_back((lambda.array() > 0.0).any());
    }
    // u_ still has the end of the last step: what this step alone has moved counts.
    warn_of_immovable_rows(scene_, contact_problem(), {pressed, state.u - u_}, state.notes);
  }
  u_ = state.u;
  return state;
}

} // namespace spricka::analysis
