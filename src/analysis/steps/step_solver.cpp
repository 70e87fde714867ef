// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/steps/step_solver.hpp"

#include "analysis/scene/sliding_contacts.hpp"
#include "analysis/steps/far_motion.hpp"
#include "analysis/steps/friction_increments.hpp"
#include "analysis/steps/held_surfaces.hpp"
#include "analysis/steps/missing_contact.hpp"
#include "analysis/steps/nodal_forces.hpp"
#include "analysis/steps/resting_forces.hpp"
#include "analysis/steps/rigid_motion.hpp"
#include "analysis/steps/round_gaps.hpp"
#include "base/dense_solve.hpp"
#include "model/model.hpp"
#include "solve/friction_index.hpp"
#include "solve/mode_split.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include <fmt/format.h>

namespace spricka::analysis {

namespace {

// Forces left over at free freedoms above this share of the force scale are not an answer.
constexpr double worst_imbalance = 1e-6;

// A determinant of more rows takes as long as an increment.
constexpr std::size_t most_rows_tested = 4000;

solve::ContactSettings settings_of(const model::Model& model) {
  solve::ContactSettings settings;
  settings.max_block_iterations = model.control.max_iterations;
  return settings;
}

// A step without contact forces, at prescribed displacements [dim * node].
StepState begin_state(const Discretisation& scene, const StepActionFactors& factors,
                      base::Vector prescribed) {
  StepState state;
  state.case_factor = factors.case_factor;
  state.mounted = factors.mounted;
  if (scene.case_temperature.size() > 0) {
    state.temperature = scene.case_temperature * factors.case_factor;
  }
  for (std::size_t c = 0; c < scene.pairs.size(); ++c) {
    const std::size_t rows = scene.table.first[c + 1] - scene.table.first[c];
    const std::size_t normal = scene.pairs[c].normal.size();
    state.pair_lambda.emplace_back(base::Vector::Zero(static_cast<Eigen::Index>(rows)));
    state.pair_gap.emplace_back(base::Vector::Zero(static_cast<Eigen::Index>(normal)));
    state.pair_closed.emplace_back(normal, false);
  }
  // Bodies are recovered into this vector: free freedoms are overwritten, prescribed ones stay.
  state.u = std::move(prescribed);
  return state;
}

// What of loads and rows the contacts could not take up.
void note_unresisted(const solve::ContactSolution& s, std::vector<results::Note>& notes) {
  if (s.resting_modes > 0) {
    notes.push_back(results::make_note(
        fmt::format("{} rigid mode(s) that no contact touches and nothing loads stay at rest",
                    s.resting_modes)));
  }
  if (s.left_over > solve::rest_load) {
    notes.push_back(
        results::make_note(fmt::format("{:.1e} of the load acts on motions that no contact touches "
                                       "(such as its moment about the axis of a meshed round "
                                       "body) and is left over",
                                       s.left_over)));
  }
  if (s.redundant > 0) {
    notes.push_back(
        results::make_note(fmt::format("{} redundant contact row(s) left out", s.redundant)));
  }
}

// The condensed body's orthonormal modes are combinations of the free rigid modes: the same
// combination on all nodes tells which way it goes. [dim * node]
base::Vector rigid_motion(const SubstructuredBody& body, const base::Vector& mode) {
  const std::vector<std::int32_t>& freedom = body.condensed->external_freedoms();
  base::Matrix at_externals(static_cast<Eigen::Index>(freedom.size()),
                            body.free_rigid_modes.cols());
  for (std::size_t i = 0; i < freedom.size(); ++i) {
    at_externals.row(static_cast<Eigen::Index>(i)) = body.free_rigid_modes.row(freedom[i]);
  }
  const base::Vector shape = body.condensed->rigid_modes() * mode;
  return body.free_rigid_modes * base::least_squares(at_externals, shape);
}

} // namespace

StepSolver::StepSolver(const model::Model& model, const Discretisation& scene,
                       const std::vector<SubstructuredBody>& bodies, MountOffsetMemory* memory,
                       ContactDataForNextLength* contact)
    : model_(model), scene_(scene), bodies_(bodies), increment_state_(model, scene, bodies, memory),
      u_(base::Vector::Zero(static_cast<Eigen::Index>(scene.cracked.mesh.node_count()) *
                            scene.cracked.mesh.dim)) {
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

std::string StepSolver::describe_unsupported_motion(const base::Vector& mode, bool slides) const {
  Eigen::Index most = 0;
  mode.cwiseAbs().maxCoeff(&most);
  const std::size_t at = system_->body_of_mode(most);
  const SubstructuredBody& body = bodies_[condensed_[at]];
  const base::Vector own =
      mode.segment(system_->first_mode(at), body.condensed->rigid_modes().cols());
  return fmt::format("body {} {}: {}{}", body.name,
                     slides ? "slides, friction does not hold it" : "is loaded but not held",
                     describe_rigid_motion(scene_.cracked.mesh, body.body, rigid_motion(body, own)),
                     slides ? ""
                            : explain_unjoined_neighbour(model_, scene_, bodies_, condensed_[at]));
}

base::OptionalFailure
StepSolver::trouble_of(const contact::ContactSystem::IncrementSolution& solution) const {
  const solve::ContactSolution& s = solution.contact;
  switch (s.status) {
  case solve::ContactStatus::solved:
    break;
  case solve::ContactStatus::unheld_mode:
    return base::OperationFailure{.kind = base::ProgramOutcome::not_solvable,
                                  .why = describe_unsupported_motion(s.unheld, solution.slides)};
  case solve::ContactStatus::inconsistent:
    return base::OperationFailure{
        .kind = base::ProgramOutcome::not_solvable,
        .why = "bonded contacts, supports and prescribed displacements contradict each other"};
  case solve::ContactStatus::max_iterations:
    return base::OperationFailure{
        .kind = base::ProgramOutcome::not_converged,
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
  if (base::OptionalFailure far =
          find_excessive_rigid_motion(scene_, bodies_, {*system_, condensed_, problem, solution},
                                      increment_state_.prescribed_displacements())) {
    trouble = std::move(far);
    return false;
  }
  note_unresisted(s, state.notes);
  std::vector<bool> closed(scene_.table.size(), true);
  for (std::size_t i = 0; i < problem.rows.size(); ++i) {
    const std::size_t row = problem.rows[i];
    const auto c = scene_.table.contact_index(row);
    const std::size_t local = row - scene_.table.first[c];
    state.pair_lambda[c][static_cast<Eigen::Index>(local)] = s.lambda[static_cast<Eigen::Index>(i)];
    if (local < scene_.pairs[c].normal.size()) {
      state.pair_gap[c][static_cast<Eigen::Index>(local)] = s.gap[static_cast<Eigen::Index>(i)];
      state.pair_closed[c][local] = s.closed[i];
    }
    closed[row] = s.closed[i];
  }
  increment_state_.set_closed_rows(std::move(closed));
  state.resting = sliding_mode_residual_force(bodies_, condensed_, solution, u_.size());
  for (std::size_t c = 0; c < scene_.pairs.size(); ++c) {
    state.friction.push_back(increment_state_.friction_history().pair_friction_state(c));
  }
  warn_of_facet_gaps(scene_, *system_, problem, solution, state.notes);
  return true;
}

void StepSolver::adopt_earlier_step(const model::Step& step, const base::Vector& u,
                                    const std::vector<bool>& closed) {
  StepActionFactors factors = increment_state_.factors();
  apply_step_actions(step, factors);
  increment_state_.set_factors(std::move(factors));
  increment_state_.set_closed_rows(closed);
  u_ = u;
}

bool StepSolver::complete(std::vector<base::Vector> external, StepState& state,
                          base::OptionalFailure& trouble) const {
  std::vector<base::Vector> of_body(bodies_.size());
  for (std::size_t i = 0; i < external.size(); ++i) {
    of_body[condensed_[i]] = std::move(external[i]);
  }
  for (std::size_t b = 0; b < bodies_.size(); ++b) {
    recover_body_displacements(bodies_[b], of_body[b], factors().case_factor, state.u);
  }
  add_nodal_forces(model_, scene_, factors().case_factor, state);
  if (state.imbalance <= worst_imbalance) {
    return true;
  }
  trouble = base::OperationFailure{
      .kind = base::ProgramOutcome::not_converged,
      .why = fmt::format("the solution is not in equilibrium: {:.1e} of the load is left over (the "
                         "stiffness is close to singular)",
                         state.imbalance)};
  return false;
}

std::optional<contact::ContactSystem::IncrementSolution>
StepSolver::walk(const StepActionFactors& from, const model::Step& step, StepState& state,
                 base::OptionalFailure& trouble) {
  StepIncrementation way(*system_, settings_of(model_), increment_state_, from, factors());
  if (contact::ContactSystem::IncrementProblem problem = contact_problem();
      problem.friction.empty()) {
    way.solve_end(std::move(problem));
  } else {
    if (const auto failed =
            refine_friction_increments(scene_, step.substeps, increment_state_, way, state.notes)) {
      trouble = trouble_of(way.solution());
      trouble->why =
          fmt::format("substep {} of {}: {}", failed->number, failed->increments, trouble->why);
      return std::nullopt;
    }
    note_uniqueness(way, state);
  }
  state.iterations = way.iterations();
  state.pivots = way.pivots();
  state.increments = way.increments();
  if (!accept(way.solution(), way.problem(), state, trouble)) {
    return std::nullopt;
  }
  return way.take_solution();
}

std::optional<contact::ContactSystem::IncrementSolution>
StepSolver::solve_increments(const StepActionFactors& to, int increments, const SeenIncrement& seen,
                             base::OptionalFailure& trouble) {
  StepIncrementation way(*system_, settings_of(model_), increment_state_, factors(), to, &seen);
  if (way.solve_increments(increments)) {
    trouble = trouble_of(way.solution());
    return std::nullopt;
  }
  return way.take_solution();
}

std::optional<StepState>
StepSolver::recover_state(contact::ContactSystem::IncrementSolution solution,
                          base::OptionalFailure& trouble) {
  StepState state = begin_state(scene_, factors(), increment_state_.prescribed_displacements());
  if (!accept(solution, contact_problem(), state, trouble) ||
      !complete(std::move(solution.u), state, trouble)) {
    return std::nullopt;
  }
  return state;
}

// A test that is sufficient only clears most; of the others the answer itself tells.
void StepSolver::note_uniqueness(const StepIncrementation& walk, StepState& state) {
  if (tested_ != factors().mounted) {
    // The test depends on the rows in force alone (solve.27): once for each set of mounted
    // contacts.
    tested_ = factors().mounted;
    certain_ = system_->prove_uniqueness(walk.problem()).certain;
  }
  if (!certain_ && walk.problem().rows.size() <= most_rows_tested &&
      solve::has_other_solutions(
          {system_->condense_problem(walk.problem()), walk.problem().friction, {}},
          {walk.solution().contact, walk.solution().touch, false})) {
    state.notes.push_back(results::questionable_input_note(
        "with this much friction the end of the step is one of several solutions: shear, pressures "
        "and K are those of one of them"));
  }
}

std::optional<StepState> StepSolver::solve(const model::Step& step,
                                           base::OptionalFailure& trouble) {
  const StepActionFactors before = factors();
  if (!increment_state_.carry_out_actions(step, u_, trouble)) {
    return std::nullopt;
  }
  StepState state = begin_state(scene_, factors(), increment_state_.prescribed_displacements());
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
