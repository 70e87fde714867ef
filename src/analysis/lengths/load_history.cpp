// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/lengths/load_history.hpp"

#include "analysis/recover/recover_step.hpp"
#include "model/model.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace spricka::analysis {

namespace {

// Of all points, as smooth functions along their fronts.
base::Vector intensities_of(const crack::KLayout& layout, const results::LoadStepResult& result) {
  base::Vector K(layout.count());
  std::size_t point = 0;
  for (const results::FrontResult& front : result.fronts) {
    for (const results::FrontPointResult& place : front.points) {
      layout.segment_of_point(K, point++) =
          base::Vec3::Map(place.smooth.data()).head(layout.mode_count());
    }
  }
  return K;
}

// The largest difference of K to that of a step, but for points where faces touch: there steps set
// more of K to 0 than the law asks for (judge_K_by_faces_and_materials).
double apart_from_step(const crack::KLayout& layout, const base::Vector& K,
                       const results::LoadStepResult& own) {
  const base::Vector other = intensities_of(layout, own);
  double apart = 0.0;
  std::size_t point = 0;
  for (const results::FrontResult& front : own.fronts) {
    for (const results::FrontPointResult& place : front.points) {
      for (int mode = 1; mode <= layout.mode_count(); ++mode) {
        const Eigen::Index at = layout.at(point, mode);
        // K1 of a tip may be 0 for its sign alone.
        const bool set = mode == 1 && front.is_tip() && other[at] == 0.0;
        if (!place.closed && !front.two_materials && !set) {
          apart = std::max(apart, std::abs(other[at] - K[at]));
        }
      }
      ++point;
    }
  }
  return apart;
}

} // namespace

void CyclicLoadHistorySolver::store_step_end_state(std::size_t step, const StepSolver& solver,
                                                   const results::LoadStepResult& result) {
  of_step_.resize(step);
  of_step_.push_back(solver.factors());
  places_.resize(step);
  places_.push_back(solver.solver_state());
  of_steps_.resize(step);
  of_steps_.push_back(intensities_of(scene_.k_layout(), result));
  const int given = model_.steps[step].substeps;
  parts_.resize(step);
  parts_.push_back(given > 0 ? given : result.increments);
}

double CyclicLoadHistorySolver::change(const KSequence& a, const KSequence& b) const {
  double most = 0.0;
  for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i) {
    most = std::max(most, (a[i] - b[i]).lpNorm<Eigen::Infinity>());
  }
  return largest_ > 0.0 ? most / largest_ : 0.0;
}

// To a place; K of the increments joins the way.
bool CyclicLoadHistorySolver::go(const LoadHistoryPoint& place, KSequence& way,
                                 base::OptionalFailure& trouble) {
  const int by_t =
      // Round-off of t must not cost another increment.
      std::max(1, static_cast<int>(std::ceil(per_unit_ * std::abs(place.t - t_) - 1e-9)));
  const auto seen = [&](const contact::ContactSystem::IncrementProblem& problem,
                        const contact::ContactSystem::IncrementSolution& solution) {
    here_ = paths_.evaluate_increment_K(problem, solution, *solver_);
    if (here_.size() > 0) {
      largest_ = std::max(largest_, here_.lpNorm<Eigen::Infinity>());
    }
    way.push_back(here_);
    ++increments_;
  };
  std::optional<contact::ContactSystem::IncrementSolution> solution = solver_->solve_increments(
      place.factors, place.increments > 0 ? place.increments : by_t, seen, trouble);
  if (!solution) {
    trouble->why = fmt::format("while the loads of the growth were followed: {}", trouble->why);
    trouble->span = model_.growth->span;
    return false;
  }
  solution_ = std::move(*solution);
  t_ = place.t;
  return true;
}

// All cycles of a leg until they repeat themselves; those that are left are told by the last.
bool CyclicLoadHistorySolver::leg(const GrowthLoadHistory& program, const RepeatedLoadSegment& leg,
                                  LoadPassResult& out, base::OptionalFailure& trouble) {
  KSequence before; // marks of the cycle before, in the end of the last
  KSequence on_the_way;
  // Cycles that stand alone begin at their own end, so that the first is a closed loop, too.
  if (leg.alone && !go(leg.places.back(), on_the_way, trouble)) {
    return false;
  }
  double left = leg.count;
  const std::size_t first_mark = out.marks.size();
  for (int n = 0; left > 0.0; ++n) {
    KSequence cycle;
    KSequence marks;
    if (leg.alone) {
      cycle.push_back(here_);
    }
    for (std::size_t p = 0; p < leg.places.size(); ++p) {
      if (!go(leg.places[p], cycle, trouble)) {
        return false;
      }
      marks.push_back(here_);
      if (first_mark + p == program.grow_at) {
        at_growth_ = solver_->solver_state();
      }
    }
    const double moved = n > 0 ? change(marks, before) : 1.0;
    const bool last = n > 0 && (moved <= repeats_to || n + 1 == most_passes);
    if (last && left > 1.0) {
      // Cycles that were cut off before they repeat themselves leave the pass unsettled.
      unsettled_ = std::max(unsettled_, moved > repeats_to ? moved : 0.0);
    }
    // Each cycle that is walked counts once, the last one for all that are left.
    const double times = last ? left : std::min(1.0, left);
    if (leg.alone) {
      out.cycles.emplace_back(std::move(cycle), times);
    } else {
      // On the way it stands once; the other times it is a closed loop of its own.
      if (times > 1.0) {
        KSequence closed = cycle;
        closed.insert(closed.begin(), out.way.back());
        out.cycles.emplace_back(std::move(closed), times - 1.0);
      }
      out.way.insert(out.way.end(), cycle.begin(), cycle.end());
    }
    left -= times;
    before = std::move(marks);
  }
  out.marks.insert(out.marks.end(), before.begin(), before.end());
  return true;
}

bool CyclicLoadHistorySolver::pass(const GrowthLoadHistory& program, LoadPassResult& out,
                                   base::OptionalFailure& trouble) {
  out = {};
  unsettled_ = 0.0;
  return std::ranges::all_of(program.legs, [&](const RepeatedLoadSegment& part) {
    return leg(program, part, out, trouble);
  });
}

// K by functionals against K of the displacements, where the last pass ends.
bool CyclicLoadHistorySolver::compare_with_recovered(LoadHistoryKResult& out,
                                                     base::OptionalFailure& trouble) {
  const bool shifted =
      std::ranges::any_of(model_.vces, [](const model::VirtualCrackExtensionSettings& vce) {
        return vce.shift.has_value();
      });
  const crack::KLayout layout = scene_.k_layout();
  const base::Vector K = here_;
  const std::optional<StepState> state = solver_->recover_state(solution_, trouble);
  if (!state) {
    trouble->span = model_.growth->span;
    return false;
  }
  const results::LoadStepResult own =
      collect_step_results(model_, scene_, bodies_, model_.steps.front(), *state);
  if (!shifted && largest_ > 0.0) {
    out.mismatch = apart_from_step(layout, K, own) / largest_;
  }
  return true;
}

// Behind the first step of the loads, or to where the cracks have grown to this length. `before`:
// K of the pass that has been, where there is one.
bool CyclicLoadHistorySolver::begin(const GrowthLoadHistory& program,
                                    const InheritedContactState& carried, KSequence& before,
                                    base::OptionalFailure& trouble) {
  if (carried.empty()) {
    solver_->restore_state(places_[program.start]);
    return true;
  }
  const std::optional<StepSolverState> place =
      carried.put(scene_, solver_->solver_state(), trouble);
  if (!place) {
    trouble->span = model_.growth->span;
    return false;
  }
  solver_->restore_state(*place);
  std::vector<LoadHistoryPoint> marks;
  for (const RepeatedLoadSegment& leg : program.legs) {
    marks.insert(marks.end(), leg.places.begin(), leg.places.end());
  }
  before.clear();
  KSequence grown; // under the loads they had
  return go({.factors = place->factors, .t = marks[program.grow_at].t, .increments = 1}, grown,
            trouble);
}

bool CyclicLoadHistorySolver::solve_load_history(StepSolver& solver, InheritedContactState& carried,
                                                 LoadHistoryKResult& out,
                                                 base::OptionalFailure& trouble) {
  const GrowthLoadHistory program = make_growth_load_history(model_, of_step_, parts_);
  out = {};
  out.none = solver.contact_system() == nullptr ? "nothing is in contact" : program.none;
  out.grow_at = program.grow_at;
  out.smallest = program.smallest;
  if (!out.none.empty()) {
    return true;
  }
  const StepSolverState was = solver.solver_state();
  solver_ = &solver;
  per_unit_ = program.per_unit;
  const bool spectrum = model_.growth->spectrum.has_value();
  KSequence before; // marks of the pass before
  if (!spectrum) {  // the steps themselves
    const auto end = of_steps_.begin() + static_cast<std::ptrdiff_t>(program.start + 1);
    // The steps as they were run are the first pass.
    before.assign(end - static_cast<std::ptrdiff_t>(program.legs.front().places.size()), end);
    out.first.marks = before;
    for (const base::Vector& K : before) {
      largest_ = std::max(largest_, K.lpNorm<Eigen::Infinity>());
    }
  }
  bool good = begin(program, carried, before, trouble);
  for (bool settled = false; good && !settled && out.passes < most_passes;) {
    good = pass(program, out.last, trouble);
    ++out.passes;
    // A pass with none before it is never settled.
    out.change = std::max(unsettled_, before.empty() ? 1.0 : change(out.last.marks, before));
    settled = out.change <= repeats_to;
    if (spectrum && out.passes == 1) {
      out.first = out.last;
    }
    before = out.last.marks;
  }
  good = good && compare_with_recovered(out, trouble);
  if (good && model_.growth->history == model::SlipHistoryOverGrowth::carry_on) {
    carried.store_state(scene_, at_growth_);
  }
  out.increments = increments_;
  solver.restore_state(was);
  return good;
}

} // namespace spricka::analysis
