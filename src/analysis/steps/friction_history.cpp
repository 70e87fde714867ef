// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/steps/friction_history.hpp"

#include <algorithm>
#include <cmath>

namespace spricka::analysis {

FrictionHistory::FrictionHistory(const Discretisation& scene)
    : scene_(scene), normal_of_(scene.table.size(), -1), contact_of_(scene.table.size(), 0) {
  const std::size_t rows = scene.table.size();
  memory_ = {.touch = std::vector<solve::SlipState>(rows, solve::SlipState::stick),
             .slip = std::vector<double>(rows, 0.0),
             .path = std::vector<double>(rows, 0.0),
             .pressure = std::vector<double>(rows, 0.0),
             .work = std::vector<double>(scene.pairs.size(), 0.0),
             .alpha = {}};
  for (std::size_t c = 0; c < scene.pairs.size(); ++c) {
    const std::size_t first = scene.table.first[c];
    mu_.push_back(scene.contacts[c].mu);
    for (std::size_t r = first; r < scene.table.first[c + 1]; ++r) {
      const contact::ConstraintRow& row = scene.contact_row(r);
      contact_of_[r] = c;
      if (mu_[c] > 0.0 && row.tangential) {
        normal_of_[r] = static_cast<std::ptrdiff_t>(first) + row.normal;
      }
    }
  }
}

void FrictionHistory::add_friction(contact::ContactSystem::IncrementProblem& problem) const {
  std::vector<int> place(normal_of_.size(), -1);
  for (std::size_t i = 0; i < problem.rows.size(); ++i) {
    place[problem.rows[i]] = static_cast<int>(i);
  }
  for (std::size_t i = 0; i < problem.rows.size(); ++i) {
    const std::size_t row = problem.rows[i];
    if (!is_friction_row(row)) {
      continue;
    }
    // A second tangent of a normal row follows the first: the two are a vector.
    const int normal = place[static_cast<std::size_t>(normal_of_[row])];
    const bool second = !problem.friction.empty() && problem.friction.back().normal == normal;
    if (second) {
      problem.friction.back().second = static_cast<int>(i);
    } else {
      problem.friction.push_back({normal, static_cast<int>(i), mu_[contact_of_[row]], -1});
    }
  }
  if (problem.friction.empty()) {
    return;
  }
  for (const std::size_t row : problem.rows) {
    problem.touch.push_back(memory_.touch[row]);
  }
  // The anchor of motions that nothing holds (solve.24).
  problem.alpha = memory_.alpha;
}

void FrictionHistory::accept_increment(const contact::ContactSystem::IncrementProblem& problem,
                                       const contact::ContactSystem::IncrementSolution& solution) {
  memory_.alpha = solution.contact.alpha;
  for (std::size_t i = 0; i < solution.touch.size(); ++i) {
    memory_.touch[problem.rows[i]] = solution.touch[i];
  }
  for (const solve::FrictionRow& f : problem.friction) {
    const std::size_t row = problem.rows[static_cast<std::size_t>(f.tangent)];
    if (memory_.touch[row] == solve::SlipState::open ||
        memory_.touch[row] == solve::SlipState::stick) {
      continue;
    }
    // Weighted: the area of the row is in it.
    const double v = solution.contact.gap[f.tangent];
    memory_.slip[row] += v;
    double way = std::abs(v);
    if (f.second >= 0) {
      const double across = solution.contact.gap[f.second];
      memory_.slip[problem.rows[static_cast<std::size_t>(f.second)]] += across;
      way = std::hypot(v, across);
    }
    memory_.path[row] += way; // of a vector with its first row
    // Friction works with the mean pressure of the increment (contact.23).
    const double before = memory_.pressure[problem.rows[static_cast<std::size_t>(f.normal)]];
    const double now = solution.contact.lambda[f.normal];
    memory_.work[contact_of_[row]] += f.mu * 0.5 * (before + now) * way;
  }
  // Pressures come last: the loop above needs those of the increment before.
  for (const solve::FrictionRow& f : problem.friction) {
    memory_.pressure[problem.rows[static_cast<std::size_t>(f.normal)]] =
        solution.contact.lambda[f.normal];
  }
}

PairFrictionState FrictionHistory::pair_friction_state(std::size_t contact) const {
  PairFrictionState pair;
  if (!(mu_[contact] > 0.0)) {
    return pair;
  }
  const std::size_t normals = scene_.pairs[contact].normal.size();
  const std::size_t first = scene_.table.first[contact];
  const auto n = static_cast<Eigen::Index>(normals);
  pair.slip = base::Vector::Zero(n);
  pair.path = base::Vector::Zero(n);
  for (std::size_t i = 0; i < normals; ++i) {
    pair.touch.push_back(memory_.touch[first + i]);
  }
  const std::vector<contact::ConstraintRow>& tangent = scene_.pairs[contact].tangent;
  for (std::size_t i = 0; i < tangent.size(); ++i) {
    const double slip = memory_.slip[first + normals + i];
    const bool second = i > 0 && tangent[i - 1].normal == tangent[i].normal;
    double& sum = pair.slip[tangent[i].normal];
    sum = second ? std::hypot(sum, slip) : slip;
    pair.path[tangent[i].normal] += memory_.path[first + normals + i];
  }
  pair.work = memory_.work[contact];
  pair.mu = mu_[contact];
  return pair;
}

void FrictionHistory::begin(std::size_t contact) {
  for (std::size_t r = scene_.table.first[contact]; r < scene_.table.first[contact + 1]; ++r) {
    memory_.slip[r] = 0.0;
    memory_.path[r] = 0.0;
    memory_.pressure[r] = 0.0;
  }
  std::fill(memory_.touch.begin(), memory_.touch.end(), solve::SlipState::stick);
}

} // namespace spricka::analysis
