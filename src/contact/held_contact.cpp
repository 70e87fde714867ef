// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/held_contact.hpp"
#include "base/index.hpp"
#include "solve/blas.hpp"

#include <algorithm>
#include <utility>

namespace spricka::contact {

using base::index;

base::Matrix openings_by_forces(const ContactSystem& system, const base::Matrix& force) {
  const base::Matrix& W = system.row_compliance_matrix();
  base::Matrix gap(W.rows(), force.cols());
  solve::blas::gemm({.m = static_cast<int>(W.rows()),
                     .n = static_cast<int>(force.cols()),
                     .k = static_cast<int>(W.cols())},
                    solve::blas::as_matrix_block(W), solve::blas::as_matrix_block(force),
                    solve::blas::as_matrix_block(gap));
  return gap;
}

base::Matrix loads_on_rigid_modes(const ContactSystem& system,
                                  const std::vector<base::Matrix>& load) {
  base::Matrix on_mode(system.openings_by_rigid_modes().cols(),
                       load.empty() ? 0 : load.front().cols());
  for (std::size_t b = 0; b < load.size(); ++b) {
    const base::Matrix& Q = system.bodies()[b]->rigid_modes();
    on_mode.middleRows(system.first_mode(b), Q.cols()) = Q.transpose() * load[b];
  }
  return on_mode;
}

ResponseWithoutContact response_without_contact(const ContactSystem& system,
                                                const std::vector<base::Matrix>& load) {
  const std::vector<const CondensedBody*>& bodies = system.bodies();
  // Loads without contact forces: rigid modes do not move, what acts on them is left in on_mode.
  ResponseWithoutContact out;
  out.on_mode = loads_on_rigid_modes(system, load);
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    // Bodies without load are many: what K feels acts on those with a front.
    out.u.push_back(load[b].isZero(0.0) ? load[b] : bodies[b]->displacements_under_forces(load[b]));
  }
  out.opening = system.row_openings(out.u);
  return out;
}

FixedActiveSet::FixedActiveSet(const ContactSystem& system, std::vector<std::size_t> rows)
    : system_(system), rows_(std::move(rows)),
      held_(system.make_equality_problem(rows_), [this](const base::Matrix& lambda) {
        base::Matrix force =
            base::Matrix::Zero(system_.row_compliance_matrix().cols(), lambda.cols());
        force(rows_, Eigen::all) = lambda;
        return base::Matrix(openings_by_forces(system_, force)(rows_, Eigen::all));
      }) {}

FixedActiveSet::ActiveSetResponse
FixedActiveSet::solve_response(const base::Matrix& gap, const base::Matrix& on_mode) const {
  base::Matrix before(index(rows_.size()), gap.cols());
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    before.row(index(i)) = gap.row(index(rows_[i]));
  }
  solve::ClosedRowsSolver::ClosedRowsResponse found =
      held_.response_to_gaps_and_loads(before, on_mode);
  ActiveSetResponse out;
  out.left_over = found.left_over;
  out.mode = std::move(found.alpha);
  out.force = base::Matrix::Zero(gap.rows(), gap.cols());
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    out.force.row(index(rows_[i])) = found.lambda.row(index(i));
  }
  return out;
}

// Of all rows of the system: those that are away open or overlap as they like.
base::Matrix FixedActiveSet::gaps_after(const base::Matrix& gap,
                                        const ActiveSetResponse& response) const {
  return gap + openings_by_forces(system_, response.force) +
         system_.openings_by_rigid_modes() * response.mode;
}

double FixedActiveSet::unheld_load(const base::Matrix& on_mode) const {
  return held_.uncontrollable_load(on_mode);
}

// Contact forces alone are solved for, which act on few unknowns: the factor's fronts without them
// are passed over.
std::vector<base::Matrix>
external_displacements(const ContactSystem& system, const ResponseWithoutContact& free,
                       const FixedActiveSet::ActiveSetResponse& response) {
  std::vector<base::Matrix> force;
  for (const base::Matrix& u : free.u) {
    force.emplace_back(base::Matrix::Zero(u.rows(), u.cols()));
  }
  for (Eigen::Index row = 0; row < response.force.rows(); ++row) {
    if ((response.force.row(row).array() != 0.0).any()) {
      system.add_row_force(base::at(row), response.force.row(row), force);
    }
  }
  std::vector<base::Matrix> u = free.u;
  for (std::size_t b = 0; b < force.size(); ++b) {
    const base::Matrix& Q = system.bodies()[b]->rigid_modes();
    if (!force[b].isZero(0.0)) {
      u[b] += system.bodies()[b]->displacements_under_forces(force[b]);
    }
    u[b] += Q * response.mode.middleRows(system.first_mode(b), Q.cols());
  }
  return u;
}

base::Vector FixedActiveSet::row_pivots(const std::vector<std::size_t>& candidates) const {
  const auto count = index(candidates.size());
  const base::Matrix& W = system_.row_compliance_matrix();
  const base::Matrix& B = system_.openings_by_rigid_modes();
  // A column for each candidate: the gap of a held row, or the force on another one, is one, and
  // the held rows answer.
  base::Matrix gap = base::Matrix::Zero(W.rows(), count);
  base::Matrix on_mode = base::Matrix::Zero(B.cols(), count);
  std::vector<bool> is_held(candidates.size());
  for (std::size_t c = 0; c < candidates.size(); ++c) {
    const auto at = index(c);
    const auto row = index(candidates[c]);
    is_held[c] = std::ranges::find(rows_, candidates[c]) != rows_.end();
    if (is_held[c]) {
      gap(row, at) = 1.0;
    } else {
      gap.col(at) = W.col(row);
      on_mode.col(at) = B.row(row).transpose();
    }
  }
  const ActiveSetResponse response = solve_response(gap, on_mode);
  const base::Matrix after = gaps_after(gap, response);
  base::Vector pivot(count);
  for (std::size_t c = 0; c < candidates.size(); ++c) {
    const auto at = index(c);
    const auto row = index(candidates[c]);
    // A held row meets a positive gap by pulling: the pivot is the other sign.
    pivot[at] = is_held[c] ? -response.force(row, at) : after(row, at);
  }
  return pivot;
}

} // namespace spricka::contact
