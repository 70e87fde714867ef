// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/system.hpp"

#include "base/index.hpp"
#include "solve/contact_qp.hpp"
#include "solve/friction.hpp"

#include <algorithm>
#include <utility>

namespace spricka::contact {

using base::at;
using base::index;

ContactSystem::ContactSystem(std::vector<const CondensedBody*> bodies,
                             std::vector<const ConstraintRow*> rows, int dim, std::size_t freedoms,
                             const std::vector<ContactRowSurfaces>& sliding,
                             const PersistentRowSet& lasting)
    : bodies_(std::move(bodies)), rows_(rows.size()) {
  // By freedom of the mesh: the body that has it among its externals, and where; -1: none has.
  std::vector<std::pair<std::int32_t, std::int32_t>> place(freedoms, {-1, -1});
  mode_start_.push_back(0);
  for (std::size_t b = 0; b < bodies_.size(); ++b) {
    const std::vector<std::int32_t>& freedom = bodies_[b]->external_freedoms();
    for (std::size_t i = 0; i < freedom.size(); ++i) {
      place[at(freedom[i])] = {static_cast<std::int32_t>(b), static_cast<std::int32_t>(i)};
    }
    mode_start_.push_back(mode_start_.back() + bodies_[b]->rigid_modes().cols());
  }
  for (std::size_t r = 0; r < rows.size(); ++r) {
    for (const RowEntry& entry : rows[r]->entries) {
      for (int c = 0; c < dim; ++c) {
        const std::size_t freedom =
            static_cast<std::size_t>(dim) * entry.node.index() + static_cast<std::size_t>(c);
        const auto [body, at] = place[freedom];
        // Suppressed and prescribed freedoms belong to no body: they drop out of the row.
        if (body >= 0 && entry.weight[c] != 0.0) {
          rows_[r].push_back({static_cast<std::size_t>(body), at, entry.weight[c]});
        }
      }
    }
  }
  compliances_ = assemble_compliances(bodies_, rows_, rows, lasting);
  let_slide(sliding, dim, place);
}

void ContactSystem::let_slide(const std::vector<ContactRowSurfaces>& sliding, int dim,
                              const std::vector<std::pair<std::int32_t, std::int32_t>>& place) {
  const auto modes_at = [&](base::NodeId node) -> std::optional<RigidModesAtNode> {
    std::optional<RigidModesAtNode> found;
    for (int c = 0; c < dim; ++c) {
      const auto [body, i] =
          place[static_cast<std::size_t>(dim) * node.index() + static_cast<std::size_t>(c)];
      if (body < 0) {
        continue; // held by a support: no mode moves it
      }
      const base::Matrix& Q = bodies_[at(body)]->rigid_modes();
      if (!found) {
        found = RigidModesAtNode{at(body), base::Matrix::Zero(dim, Q.cols())};
      }
      if (Q.cols() > 0) {
        found->motion.row(c) = Q.row(i);
      }
    }
    return found;
  };
  slid_ = compliances_.B;
  remove_self_sliding_openings(sliding, mode_start_, modes_at, compliances_.B);
  slid_ -= compliances_.B;
}

std::vector<base::Vector> ContactSystem::resting_force(const std::vector<std::size_t>& rows,
                                                       const base::Vector& lambda) const {
  base::Vector on_mode = base::Vector::Zero(slid_.cols());
  for (std::size_t i = 0; i < rows.size(); ++i) {
    on_mode += lambda[index(i)] * slid_.row(index(rows[i])).transpose();
  }
  std::vector<base::Vector> force;
  for (std::size_t b = 0; b < bodies_.size() && !on_mode.isZero(0.0); ++b) {
    const base::Matrix& Q = bodies_[b]->rigid_modes();
    force.emplace_back(Q * on_mode.segment(mode_start_[b], Q.cols()));
  }
  return force;
}

double ContactSystem::row_opening(std::size_t row, const std::vector<base::Vector>& u) const {
  double sum = 0.0;
  for (const BodyRowEntry& e : rows_[row]) {
    sum += e.weight * u[e.body][e.at];
  }
  return sum;
}

std::size_t ContactSystem::body_of_mode(Eigen::Index mode) const {
  std::size_t b = 0;
  while (mode >= mode_start_[b + 1]) {
    ++b;
  }
  return b;
}

base::Vector ContactSystem::motion_of(const IncrementProblem& problem, std::size_t body) const {
  const bool known = body < problem.motion.size() && problem.motion[body].size() > 0;
  return known ? problem.motion[body]
               : base::Vector(bodies_[body]->displacements_under_forces(problem.load[body]));
}

solve::ContactProblem ContactSystem::condense_problem(const IncrementProblem& problem) const {
  const auto n = index(problem.rows.size());
  std::vector<base::Vector> u(bodies_.size());
  solve::ContactProblem small = make_equality_problem(problem.rows);
  for (std::size_t b = 0; b < bodies_.size(); ++b) {
    // b and h of (solve.11): gaps as the loads alone leave them, and the loads on the modes.
    u[b] = motion_of(problem, b);
    small.h.segment(mode_start_[b], bodies_[b]->rigid_modes().cols()) =
        bodies_[b]->rigid_modes().transpose() * problem.load[b];
  }
  for (Eigen::Index i = 0; i < n; ++i) {
    small.b[i] = problem.gap[i] + row_opening(problem.rows[at(i)], u);
  }
  small.equality = problem.equality;
  small.load_scale = problem.load_scale;
  return small;
}

solve::ContactProblem
ContactSystem::make_equality_problem(const std::vector<std::size_t>& rows) const {
  const auto n = index(rows.size());
  solve::ContactProblem small;
  small.W.resize(n, n);
  small.B.resize(n, compliances_.B.cols());
  for (Eigen::Index i = 0; i < n; ++i) {
    const auto row = index(rows[at(i)]);
    for (Eigen::Index k = 0; k < n; ++k) {
      small.W(k, i) = compliances_.W(index(rows[at(k)]), row);
    }
    small.B.row(i) = compliances_.B.row(row);
  }
  small.b = base::Vector::Zero(n);
  small.h = base::Vector::Zero(compliances_.B.cols());
  small.equality.assign(rows.size(), true);
  small.opening_scale = compliances_.opening_scale;
  return small;
}

base::Matrix ContactSystem::row_openings(const std::vector<base::Matrix>& u) const {
  base::Matrix out = base::Matrix::Zero(index(rows_.size()), u.empty() ? 0 : u.front().cols());
  for (std::size_t r = 0; r < rows_.size(); ++r) {
    for (const BodyRowEntry& e : rows_[r]) {
      out.row(index(r)) += e.weight * u[e.body].row(e.at);
    }
  }
  return out;
}

void ContactSystem::add_row_force(std::size_t row, const Eigen::RowVectorXd& force,
                                  std::vector<base::Matrix>& load) const {
  for (const BodyRowEntry& e : rows_[row]) {
    load[e.body].row(e.at) += e.weight * force;
  }
}

solve::UniquenessResult ContactSystem::prove_uniqueness(const IncrementProblem& problem) const {
  if (solve::has_round_cones(problem.friction)) {
    return {}; // the test is one of signs
  }
  return solve::check_uniqueness({condense_problem(problem), problem.friction, {}});
}

ContactSystem::IncrementSolution
ContactSystem::solve_rows(const IncrementProblem& problem,
                          const solve::ContactSettings& settings) const {
  IncrementSolution solution;
  if (problem.friction.empty()) {
    solution.contact = solve::solve_contact(condense_problem(problem), settings, problem.start);
  } else {
    solve::FrictionSolution found = solve::solve_friction(
        {condense_problem(problem), problem.friction, problem.alpha, problem.expected}, settings,
        problem.touch);
    solution.contact = std::move(found.contact);
    solution.touch = std::move(found.touch);
    solution.slides = found.slides;
  }
  return solution;
}

ContactSystem::IncrementSolution
ContactSystem::solve(const IncrementProblem& problem,
                     const solve::ContactSettings& settings) const {
  IncrementSolution solution = solve_rows(problem, settings);
  if (solution.contact.status == solve::ContactStatus::solved) {
    add_displacements(problem, solution);
  }
  return solution;
}

// u = S+ (f + G^T lambda) + Q alpha, body by body.
void ContactSystem::add_displacements(const IncrementProblem& problem,
                                      IncrementSolution& solution) const {
  const solve::ContactSolution& s = solution.contact;
  std::vector<base::Vector> force = problem.load;
  for (std::size_t b = 0; b < problem.motion.size(); ++b) {
    if (problem.motion[b].size() > 0) {
      force[b].setZero(); // what the loads do is known
    }
  }
  for (Eigen::Index i = 0; i < s.lambda.size(); ++i) {
    for (const BodyRowEntry& e : rows_[problem.rows[at(i)]]) {
      force[e.body][e.at] += s.lambda[i] * e.weight;
    }
  }
  for (std::size_t b = 0; b < bodies_.size(); ++b) {
    solution.u.push_back(bodies_[b]->displacements_under_forces(force[b]) +
                         bodies_[b]->rigid_modes() *
                             s.alpha.segment(mode_start_[b], bodies_[b]->rigid_modes().cols()));
    if (b < problem.motion.size() && problem.motion[b].size() > 0) {
      solution.u.back() += problem.motion[b];
    }
  }
  solution.resting_force = resting_force(problem.rows, s.lambda);
}

} // namespace spricka::contact
