// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/steps/friction_increments.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace spricka::analysis {

namespace {

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

void note_slips(const Halving& cut, bool given, std::vector<results::Note>& notes) {
  if (cut.slip_error() > work_tolerance) {
    notes.push_back(results::less_exact_note(
        fmt::format("with friction followed in {} increments, its work or the largest slip is off "
                    "by about {:.2g} %: {}",
                    cut.now, 100.0 * cut.slip_error(),
                    given ? "more SUBSTEPS, or none, make it less" : "SUBSTEPS may ask for more")));
  }
}

void note_increments(const Halving& cut, bool given, std::vector<results::Note>& notes) {
  const double error = cut.error();
  if (error < round_off_shear) {
    return;
  }
  const std::string off = fmt::format("shear off by about {:.2g} %", 100.0 * error);
  if (error <= worst_shear) {
    notes.push_back(results::make_note(
        fmt::format("friction walked in {} increments: {} (root mean square)", cut.now, off)));
  } else if (given) {
    notes.push_back(results::less_exact_note(fmt::format(
        "SUBSTEPS={} leaves the {} (root mean square, from the change between {} and {} "
        "increments); without SUBSTEPS the step is cut until 1 % is left",
        cut.now, off, std::min(cut.before, cut.now), std::max(cut.before, cut.now))));
  } else {
    notes.push_back(results::less_exact_note(fmt::format(
        "friction walked in {} increments leaves the {} (root mean square): SUBSTEPS may "
        "ask for more",
        cut.now, off)));
  }
}

} // namespace

std::optional<FailedIncrement> refine_friction_increments(const Discretisation& scene, int substeps,
                                                          IncrementState& state,
                                                          StepIncrementation& incrementation,
                                                          std::vector<results::Note>& notes) {
  const StepSolverState start = state.solver_state();
  const auto walk = [&](int increments) -> std::optional<FailedIncrement> {
    state.restore_state(start);
    const std::optional<int> failed = incrementation.solve_increments(increments);
    return failed ? std::optional(FailedIncrement{*failed, increments}) : std::nullopt;
  };
  const bool given = substeps > 0;
  Halving cut;
  if (given) {
    // SUBSTEPS are walked last, so that theirs is the answer; the other walk only tells their
    // error.
    cut = {.before = substeps == 1 ? 2 : substeps / 2, .now = substeps};
  }
  const std::optional<FailedIncrement> coarse = walk(cut.before);
  // Where SUBSTEPS are given a coarser walk without answer leaves them without a known error only.
  if (coarse && !given) {
    return coarse;
  }
  for (;;) {
    const contact::ContactSystem::IncrementSolution last = incrementation.take_solution();
    const FrictionState slipped = state.friction_history().friction_state();
    if (const std::optional<FailedIncrement> failed = walk(cut.now)) {
      return failed;
    }
    if (!coarse) {
      cut.change =
          friction_change(scene, incrementation.problem(), last, incrementation.solution());
      cut.slip = slip_change(scene, incrementation.problem(), incrementation.solution(), slipped,
                             state.friction_history().friction_state());
    }
    const bool settled = cut.change <= shear_tolerance && cut.slip <= work_tolerance;
    if (given || settled || cut.now >= most_increments) {
      break;
    }
    cut.before = cut.now;
    cut.now *= 2;
  }
  note_increments(cut, given, notes);
  note_slips(cut, given, notes);
  return std::nullopt;
}

} // namespace spricka::analysis
