// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/adjoint/contact_rates.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace spricka::analysis {

namespace {

constexpr double small = 1e-8; ///< of the largest force or gap: may change either way

} // namespace

FrozenContact::FrozenContact(const StepSolver& solver, const Discretisation& scene,
                             const StepState& state)
    : system_(*solver.contact_system()) {
  const contact::ContactSystem::IncrementProblem problem = solver.contact_problem();
  double force_size = 0.0;
  double gap_size = 0.0;
  for (std::size_t i = 0; i < problem.rows.size(); ++i) {
    FrozenContactRow row{
        .row = problem.rows[i], .equality = problem.equality[i], .closed = problem.start[i]};
    const std::size_t c = scene.table.contact_index(row.row);
    const std::size_t local = row.row - scene.table.first[c];
    row.force = state.pair_lambda[c][static_cast<Eigen::Index>(local)];
    if (!row.equality) {
      row.gap = state.pair_gap[c][static_cast<Eigen::Index>(local)];
    }
    const double area = scene.contact_row(row.row).area;
    const double given = std::abs(problem.gap[static_cast<Eigen::Index>(i)]);
    force_size = std::max(force_size, std::abs(row.force));
    // A fit that is just closed has no gap left: what was given tells the size, too.
    gap_size = std::max(gap_size, (given + std::abs(row.gap)) / area);
    rows_.push_back(row);
  }
  for (FrozenContactRow& row : rows_) {
    const double area = scene.contact_row(row.row).area;
    // Gaps are weighted: over their areas those of large and small rows compare.
    row.weak = !row.equality &&
               (row.closed ? row.force <= small * force_size : row.gap / area <= small * gap_size);
    weak_ += row.weak ? 1 : 0;
  }
}

std::optional<std::vector<bool>>
FrozenContact::closed_rows_after(const LoadAndGapRates& rates, Eigen::Index k, double sign) const {
  contact::ContactSystem::IncrementProblem problem;
  std::vector<double> gap;
  for (const FrozenContactRow& row : rows_) {
    if (row.closed || row.weak) {
      problem.rows.push_back(row.row);
      // Rows that press well stay closed, whatever the sign of their rate; open ones with a gap are
      // left out.
      problem.equality.push_back(!row.weak);
      gap.push_back(sign * rates.gap(static_cast<Eigen::Index>(row.row), k));
    }
  }
  problem.gap = Eigen::Map<const base::Vector>(gap.data(), static_cast<Eigen::Index>(gap.size()));
  for (const base::Matrix& load : rates.load) {
    problem.load.emplace_back(sign * load.col(k));
  }
  problem.load_scale = rates.load_scale[k];
  const solve::ContactSolution found = system_.solve(problem, {}).contact;
  if (found.status != solve::ContactStatus::solved) {
    return std::nullopt;
  }
  std::vector<bool> closed(static_cast<std::size_t>(rates.gap.rows()), false);
  for (std::size_t i = 0; i < problem.rows.size(); ++i) {
    closed[problem.rows[i]] = found.closed[i];
  }
  return closed;
}

std::vector<std::array<double, 2>>
FrozenContact::linear_ranges(const contact::FixedActiveSet& held,
                             const LoadAndGapRates& rates) const {
  const base::Matrix before = rates.gap + rates.free.opening;
  const contact::FixedActiveSet::ActiveSetResponse rate =
      held.solve_response(before, rates.free.on_mode);
  const base::Matrix gap = held.gaps_after(before, rate);
  constexpr double never = std::numeric_limits<double>::infinity();
  std::vector<std::array<double, 2>> out(static_cast<std::size_t>(rates.gap.cols()),
                                         {-never, never});
  for (const FrozenContactRow& row : rows_) {
    if (row.equality || row.weak) {
      continue;
    }
    const Eigen::RowVectorXd by =
        (row.closed ? rate.force : gap).row(static_cast<Eigen::Index>(row.row));
    // A force or gap that falls at this rate is used up at (sensitivity.11).
    const double value = row.closed ? row.force : row.gap;
    for (Eigen::Index k = 0; k < by.size(); ++k) {
      auto& [down, up] = out[static_cast<std::size_t>(k)];
      if (by[k] < 0.0) {
        up = std::min(up, -value / by[k]);
      } else if (by[k] > 0.0) {
        down = std::max(down, -value / by[k]);
      }
    }
  }
  return out;
}

} // namespace spricka::analysis
