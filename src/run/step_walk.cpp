// SPDX-License-Identifier: GPL-3.0-or-later
#include "run/step_walk.hpp"

#include "run/step_solver.hpp"

#include <fmt/format.h>

namespace spricka::run {

namespace {

// An increment with friction that does not converge is halved so often.
constexpr int most_halvings = 6;

solve::ContactSettings settings_of(const model::Model& model) {
  solve::ContactSettings settings;
  settings.max_block_iterations = model.control.max_iterations;
  return settings;
}

} // namespace

double row_opening(const contact::ConstraintRow& row, int dim, const base::Vector& u) {
  double sum = 0.0;
  for (const contact::RowEntry& entry : row.entries) {
    const auto at = static_cast<Eigen::Index>(entry.node.index()) * dim;
    for (int c = 0; c < dim; ++c) {
      sum += entry.weight[c] * u[at + c];
    }
  }
  return sum;
}

std::optional<contact::ContactSystem::Answer> StepSolver::walk(const StepFactors& from,
                                                               const model::Step& step,
                                                               StepState& state, Refusal& refusal) {
  Walk way{from, factors_, demand(), {}, 0, 0, 0, nullptr};
  const bool rubs = !way.demand.friction.empty();
  if (rubs) {
    note_uniqueness(way.demand, state);
    for (int k = 0; k < step.substeps; ++k) {
      const double n = step.substeps;
      if (advance(way, {k / n, (k + 1) / n}, 0)) {
        continue;
      }
      refuse(way.answer, refusal);
      refusal.why = fmt::format("substep {} of {}: {}", k + 1, step.substeps, refusal.why);
      return std::nullopt;
    }
  } else {
    way.answer = system_->solve(way.demand, settings_of(model_));
    way.iterations = way.answer.solution.block_iterations;
    way.pivots = way.answer.solution.pivots;
    way.increments = 1;
  }
  state.iterations = way.iterations;
  state.pivots = way.pivots;
  state.increments = way.increments;
  if (!accept(way.answer, way.demand, state, refusal)) {
    return std::nullopt;
  }
  return std::move(way.answer);
}

bool StepSolver::advance(Walk& walk, std::pair<double, double> part, int halvings) {
  factors_ = part_way(walk.from, walk.to, part.second);
  walk.demand = demand();
  walk.answer = system_->solve(walk.demand, settings_of(model_));
  const solve::ContactSolution& s = walk.answer.solution;
  walk.iterations += s.block_iterations;
  walk.pivots += s.pivots;
  if (s.status == solve::ContactStatus::solved) {
    ++walk.increments;
    remember(walk);
    if (walk.seen != nullptr) {
      (*walk.seen)(walk.demand, walk.answer);
    }
    return true;
  }
  if (s.status != solve::ContactStatus::max_iterations || halvings == most_halvings) {
    return false;
  }
  const double middle = 0.5 * (part.first + part.second);
  return advance(walk, {part.first, middle}, halvings + 1) &&
         advance(walk, {middle, part.second}, halvings + 1);
}

StepSolver::Place StepSolver::place() const {
  return {factors_, offset_, closed_, history_.memory()};
}

void StepSolver::go_back(const Place& place) {
  factors_ = place.factors;
  offset_ = place.offset;
  closed_ = place.closed;
  history_.go_back(place.friction);
}

std::optional<contact::ContactSystem::Answer>
StepSolver::go_to(const StepFactors& to, int increments, const Seen& seen, Refusal& refusal) {
  Walk way{factors_, to, {}, {}, 0, 0, 0, &seen};
  for (int k = 0; k < increments; ++k) {
    const double n = increments;
    if (!advance(way, {k / n, (k + 1) / n}, 0)) {
      refuse(way.answer, refusal);
      return std::nullopt;
    }
  }
  return std::move(way.answer);
}

std::optional<StepState> StepSolver::recover(contact::ContactSystem::Answer answer,
                                             Refusal& refusal) {
  StepState state = begin_state();
  if (!accept(answer, demand(), state, refusal) || !complete(std::move(answer.u), state, refusal)) {
    return std::nullopt;
  }
  return state;
}

// Where rows stand tangentially now: slip counts from here.
void StepSolver::remember(const Walk& walk) {
  history_.take(walk.demand, walk.answer);
  const base::Vector fixed = prescribed();
  for (const std::size_t row : walk.demand.rows) {
    if (history_.rubs(row)) {
      offset_[static_cast<Eigen::Index>(row)] =
          -system_->opening(row, walk.answer.u) -
          row_opening(*scene_.table.rows[row], scene_.cracked.mesh.dim, fixed);
    }
  }
}

void StepSolver::note_uniqueness(const contact::ContactSystem::Demand& demand, StepState& state) {
  if (tested_ == factors_.mounted) {
    return;
  }
  tested_ = factors_.mounted;
  if (!system_->unique(demand).certain) {
    state.notes.emplace_back("with this much friction a test that is sufficient only did not rule "
                             "out that the increments "
                             "have other solutions");
  }
}

} // namespace spricka::run
