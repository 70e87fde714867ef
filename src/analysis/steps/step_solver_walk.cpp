// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/steps/row_opening.hpp"
#include "analysis/steps/step_solver.hpp"
#include "model/model.hpp"
#include "solve/friction_index.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace spricka::analysis {

namespace {

// An increment with friction that does not converge is halved so often.
constexpr int most_halvings = 6;

// A step that is cut by itself is cut until its shear changes by no more than this part of itself,
// and no further than this.
constexpr double shear_tolerance = 0.01;
constexpr int most_increments = 64;
// The work of friction and the largest slip by no more than this part of them.
constexpr double work_tolerance = 0.05;
// Shear that is less than this part of mu p is measured by that.
constexpr double least_shear = 0.25;
// It is warned of where its shear is off by more.
constexpr double worst_shear = 0.05;
// Less is not told.
constexpr double round_off_shear = 1e-6;
// A determinant of more rows takes as long as an increment.
constexpr std::size_t most_rows_tested = 4000;

// Shear of contacts that rub in two answers to the same problem: root mean square of what it
// changes by over that of the shear, the largest of all contacts (manual, contact.25).
double friction_change(const Discretisation& scene,
                       const contact::ContactSystem::IncrementProblem& problem,
                       const contact::ContactSystem::IncrementSolution& a,
                       const contact::ContactSystem::IncrementSolution& b) {
  struct Sum {
    double change = 0.0, shear = 0.0, limit = 0.0;
  };
  std::vector<Sum> sums(scene.pairs.size());
  for (const solve::FrictionRow& f : problem.friction) {
    const std::size_t row = problem.rows[static_cast<std::size_t>(f.tangent)];
    const auto c = scene.table.contact_index(row);
    const double area = scene.contact_row(row).area;
    const base::Vector& q = b.contact.lambda;
    for (const int t : {f.tangent, f.second}) {
      if (t >= 0) {
        sums[c].change += area * std::pow(a.contact.lambda[t] - q[t], 2);
        sums[c].shear += area * std::pow(q[t], 2);
      }
    }
    sums[c].limit += area * std::pow(least_shear * f.mu * q[f.normal], 2);
  }
  double most = 0.0;
  for (const Sum& sum : sums) {
    // Shear that is next to nothing would change by much of itself however fine the walk.
    const double scale = std::max(sum.shear, sum.limit);
    most = std::max(most, scale > 0.0 ? std::sqrt(sum.change / scale) : 0.0);
  }
  return most;
}

// Slip below this part of the displacements, and work below that of friction's forces along it, is
// nothing: bodies that are pressed together alone hardly slip.
constexpr double least_slip = 1e-3;

// The same of the work of friction, over the largest of all contacts, or of the largest way that a
// row has slid, whichever changes by more. `solution` and `b` are of the later walk.
double slip_change(const Discretisation& scene,
                   const contact::ContactSystem::IncrementProblem& problem,
                   const contact::ContactSystem::IncrementSolution& solution,
                   const FrictionState& a, const FrictionState& b) {
  double motion = 0.0;
  for (const base::Vector& u : solution.u) {
    motion = std::max(motion, u.size() > 0 ? u.cwiseAbs().maxCoeff() : 0.0);
  }
  double force = 0.0;
  for (const solve::FrictionRow& f : problem.friction) {
    const std::size_t row = problem.rows[static_cast<std::size_t>(f.normal)];
    // All that friction could pull: with the largest displacement a scale for its work.
    force += f.mu * solution.contact.lambda[f.normal] * scene.contact_row(row).area;
  }
  const double work = std::max(std::ranges::max(b.work), least_slip * force * motion);
  double most = 0.0;
  for (std::size_t c = 0; c < b.work.size() && work > 0.0; ++c) {
    most = std::max(most, std::abs(a.work[c] - b.work[c]) / work);
  }
  double before = 0.0;
  double now = 0.0;
  for (std::size_t r = 0; r < b.path.size(); ++r) {
    // Weighted slips over the area of their row are lengths.
    const double area = scene.contact_row(r).area;
    before = std::max(before, a.path[r] / area);
    now = std::max(now, b.path[r] / area);
  }
  const double slip = std::max(now, least_slip * motion);
  return slip > 0.0 ? std::max(most, std::abs(now - before) / slip) : most;
}

// Two walks of a step, in `before` and in `now` increments, and what they differ by. An error that
// falls with 1/n leaves m / |n - m| of that in the second (contact.25).
struct Halving {
  int before = 1, now = 2;
  double change = 0.0; ///< of the shear
  double slip = 0.0;   ///< of the work of friction and the largest slip

  [[nodiscard]] double error() const { return change * part(); }
  [[nodiscard]] double slip_error() const { return slip * part(); }
  [[nodiscard]] double part() const { return before / static_cast<double>(std::abs(now - before)); }
};

void note_slips(const Halving& cut, bool given, StepState& state) {
  if (cut.slip_error() > work_tolerance) {
    state.notes.push_back(results::less_exact_note(
        fmt::format("with friction followed in {} increments, its work or the largest slip is off "
                    "by about {:.2g} %: {}",
                    cut.now, 100.0 * cut.slip_error(),
                    given ? "more SUBSTEPS, or none, make it less" : "SUBSTEPS may ask for more")));
  }
}

void note_increments(const Halving& cut, bool given, StepState& state) {
  const double error = cut.error();
  if (error < round_off_shear) {
    return;
  }
  const std::string off = fmt::format("shear off by about {:.2g} %", 100.0 * error);
  if (error <= worst_shear) {
    state.notes.push_back(results::note(
        fmt::format("friction walked in {} increments: {} (root mean square)", cut.now, off)));
  } else if (given) {
    state.notes.push_back(results::less_exact_note(fmt::format(
        "SUBSTEPS={} leaves the {} (root mean square, from the change between {} and {} "
        "increments); without SUBSTEPS the step is cut until 1 % is left",
        cut.now, off, std::min(cut.before, cut.now), std::max(cut.before, cut.now))));
  } else {
    state.notes.push_back(results::less_exact_note(fmt::format(
        "friction walked in {} increments leaves the {} (root mean square): SUBSTEPS may "
        "ask for more",
        cut.now, off)));
  }
}

solve::ContactSettings settings_of(const model::Model& model) {
  solve::ContactSettings settings;
  settings.max_block_iterations = model.control.max_iterations;
  return settings;
}

} // namespace

std::optional<contact::ContactSystem::IncrementSolution>
StepSolver::walk(const StepActionFactors& from, const model::Step& step, StepState& state,
                 base::OptionalFailure& trouble) {
  StepIncrementation way{
      .from = from, .to = factors_, .problem = contact_problem(), .solution = {}};
  const bool rubs = !way.problem.friction.empty();
  if (rubs) {
    if (!walk_rubbing(way, step, state, trouble)) {
      return std::nullopt;
    }
    note_uniqueness(way, state);
  } else {
    way.solution = system_->solve(way.problem, settings_of(model_));
    way.iterations = way.solution.contact.block_iterations;
    way.pivots = way.solution.contact.pivots;
    way.increments = 1;
  }
  state.iterations = way.iterations;
  state.pivots = way.pivots;
  state.increments = way.increments;
  if (!accept(way.solution, way.problem, state, trouble)) {
    return std::nullopt;
  }
  return std::move(way.solution);
}

bool StepSolver::walk_load_path(StepIncrementation& walk, const StepSolverState& start,
                                int increments, base::OptionalFailure& trouble) {
  restore_state(start);
  walk.increments = 0;
  walk.reached.clear();
  for (int k = 0; k < increments; ++k) {
    const double n = increments;
    if (!advance(walk, {k / n, (k + 1) / n}, 0)) {
      trouble = trouble_of(walk.solution);
      trouble->why = fmt::format("substep {} of {}: {}", k + 1, increments, trouble->why);
      return false;
    }
  }
  return true;
}

bool StepSolver::walk_rubbing(StepIncrementation& walk, const model::Step& step, StepState& state,
                              base::OptionalFailure& trouble) {
  const StepSolverState start = solver_state();
  const bool given = step.substeps > 0;
  Halving cut;
  if (given) {
    // SUBSTEPS are walked last, so that theirs is the answer; the other walk only tells their
    // error.
    cut = {.before = step.substeps == 1 ? 2 : step.substeps / 2, .now = step.substeps};
  }
  base::OptionalFailure coarse;
  const bool compared = walk_load_path(walk, start, cut.before, coarse);
  // Where SUBSTEPS are given a coarser walk without answer leaves them without a known error only.
  if (!compared && !given) {
    trouble = coarse;
    return false;
  }
  for (;;) {
    const contact::ContactSystem::IncrementSolution last = std::move(walk.solution);
    const FrictionState slipped = history_.friction_state();
    if (!walk_load_path(walk, start, cut.now, trouble)) {
      return false;
    }
    cut.change = compared ? friction_change(scene_, walk.problem, last, walk.solution) : 0.0;
    cut.slip = compared ? slip_change(scene_, walk.problem, walk.solution, slipped,
                                      history_.friction_state())
                        : 0.0;
    const bool settled = cut.change <= shear_tolerance && cut.slip <= work_tolerance;
    if (given || settled || cut.now >= most_increments) {
      break;
    }
    cut.before = cut.now;
    cut.now *= 2;
  }
  note_increments(cut, given, state);
  note_slips(cut, given, state);
  return true;
}

// In a straight line from the last two increments: most points go on as they did.
solve::ExpectedForces StepSolver::expected_at(const StepIncrementation& walk, double part) {
  if (walk.reached.empty()) {
    return {};
  }
  const StepIncrementation::ReachedIncrement& last = walk.reached.back();
  const StepIncrementation::ReachedIncrement& before = walk.reached.front();
  const double way = last.at - before.at;
  const double further = way > 0.0 ? (part - last.at) / way : 0.0;
  return {last.forces.lambda + further * (last.forces.lambda - before.forces.lambda),
          last.forces.alpha + further * (last.forces.alpha - before.forces.alpha)};
}

bool StepSolver::advance(StepIncrementation& walk, std::pair<double, double> part, int halvings) {
  factors_ = interpolate_step_factors(walk.from, walk.to, part.second);
  walk.problem = contact_problem();
  walk.problem.expected = expected_at(walk, part.second);
  walk.solution = system_->solve(walk.problem, settings_of(model_));
  const solve::ContactSolution& s = walk.solution.contact;
  walk.iterations += s.block_iterations;
  walk.pivots += s.pivots;
  if (s.status == solve::ContactStatus::solved) {
    ++walk.increments;
    remember(walk);
    walk.reached.push_back({part.second, {s.lambda, s.alpha}});
    if (walk.reached.size() > 2) {
      walk.reached.erase(walk.reached.begin());
    }
    if (walk.seen != nullptr) {
      (*walk.seen)(walk.problem, walk.solution);
    }
    return true;
  }
  // Only what did not converge is halved: loads that nothing holds, and bonds that contradict each
  // other, would be met again.
  if (s.status != solve::ContactStatus::max_iterations || halvings == most_halvings) {
    return false;
  }
  const double middle = 0.5 * (part.first + part.second);
  return advance(walk, {part.first, middle}, halvings + 1) &&
         advance(walk, {middle, part.second}, halvings + 1);
}

StepSolver::StepSolverState StepSolver::solver_state() const {
  return {factors_, offset_, closed_, history_.friction_state()};
}

void StepSolver::restore_state(const StepSolverState& place) {
  factors_ = place.factors;
  offset_ = place.offset;
  closed_ = place.closed;
  history_.restore_state(place.friction);
}

std::optional<contact::ContactSystem::IncrementSolution>
StepSolver::solve_increments(const StepActionFactors& to, int increments, const Seen& seen,
                             base::OptionalFailure& trouble) {
  StepIncrementation way{.from = factors_, .to = to, .problem = {}, .solution = {}, .seen = &seen};
  for (int k = 0; k < increments; ++k) {
    const double n = increments;
    if (!advance(way, {k / n, (k + 1) / n}, 0)) {
      trouble = trouble_of(way.solution);
      return std::nullopt;
    }
  }
  return std::move(way.solution);
}

std::optional<StepState>
StepSolver::recover_state(contact::ContactSystem::IncrementSolution solution,
                          base::OptionalFailure& trouble) {
  StepState state = begin_state();
  if (!accept(solution, contact_problem(), state, trouble) ||
      !complete(std::move(solution.u), state, trouble)) {
    return std::nullopt;
  }
  return state;
}

// Where rows stand tangentially now: the slip of the next increment counts from here (contact.22).
void StepSolver::remember(const StepIncrementation& walk) {
  history_.accept_increment(walk.problem, walk.solution);
  const base::Vector fixed = prescribed();
  for (const std::size_t row : walk.problem.rows) {
    if (history_.has_friction(row)) {
      offset_[static_cast<Eigen::Index>(row)] =
          -system_->opening(row, walk.solution.u) -
          row_opening(scene_.contact_row(row), scene_.cracked.mesh.dim, fixed);
    }
  }
}

// A test that is sufficient only clears most; of the others the answer itself tells.
void StepSolver::note_uniqueness(const StepIncrementation& walk, StepState& state) {
  if (tested_ != factors_.mounted) {
    // The test depends on the rows in force alone (solve.27): once for each set of mounted
    // contacts.
    tested_ = factors_.mounted;
    certain_ = system_->unique(walk.problem).certain;
  }
  if (!certain_ && walk.problem.rows.size() <= most_rows_tested &&
      solve::has_other_solutions({system_->condensed(walk.problem), walk.problem.friction, {}},
                                 {walk.solution.contact, walk.solution.touch, false})) {
    state.notes.push_back(results::questionable_note(
        "with this much friction the end of the step is one of several solutions: shear, pressures "
        "and K are those of one of them"));
  }
}

} // namespace spricka::analysis
