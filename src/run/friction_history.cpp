// SPDX-License-Identifier: GPL-3.0-or-later
#include "run/friction_history.hpp"

#include <algorithm>
#include <cmath>

namespace spricka::run {

FrictionHistory::FrictionHistory(const Scene& scene)
    : scene_(scene), normal_of_(scene.table.rows.size(), -1),
      contact_of_(scene.table.rows.size(), 0), touch_(scene.table.rows.size(), solve::Touch::stick),
      slip_(scene.table.rows.size(), 0.0), path_(scene.table.rows.size(), 0.0),
      work_(scene.pairs.size(), 0.0) {
  for (std::size_t c = 0; c < scene.pairs.size(); ++c) {
    const std::size_t first = scene.table.first[c];
    const std::size_t normals = scene.pairs[c].normal.size();
    mu_.push_back(scene.contacts[c].mu);
    for (std::size_t r = first; r < scene.table.first[c + 1]; ++r) {
      contact_of_[r] = c;
      if (mu_[c] > 0.0 && r >= first + normals) {
        normal_of_[r] = static_cast<std::ptrdiff_t>(r - normals);
      }
    }
  }
}

void FrictionHistory::add_to(contact::ContactSystem::Demand& demand) const {
  std::vector<int> place(normal_of_.size(), -1);
  for (std::size_t i = 0; i < demand.rows.size(); ++i) {
    place[demand.rows[i]] = static_cast<int>(i);
  }
  for (std::size_t i = 0; i < demand.rows.size(); ++i) {
    const std::size_t row = demand.rows[i];
    if (rubs(row)) {
      demand.friction.push_back({place[static_cast<std::size_t>(normal_of_[row])],
                                 static_cast<int>(i), mu_[contact_of_[row]]});
    }
  }
  if (demand.friction.empty()) {
    return;
  }
  for (const std::size_t row : demand.rows) {
    demand.touch.push_back(touch_[row]);
  }
  demand.alpha = alpha_;
}

void FrictionHistory::take(const contact::ContactSystem::Demand& demand,
                           const contact::ContactSystem::Answer& answer) {
  alpha_ = answer.solution.alpha;
  for (std::size_t i = 0; i < answer.touch.size(); ++i) {
    touch_[demand.rows[i]] = answer.touch[i];
  }
  for (const solve::FrictionRow& f : demand.friction) {
    const std::size_t row = demand.rows[static_cast<std::size_t>(f.tangent)];
    if (touch_[row] == solve::Touch::open) {
      continue;
    }
    const double v = answer.solution.gap[f.tangent];
    slip_[row] += v;
    path_[row] += std::abs(v);
    work_[contact_of_[row]] -= answer.solution.lambda[f.tangent] * v;
  }
}

PairFriction FrictionHistory::pair(std::size_t contact) const {
  PairFriction pair;
  if (!(mu_[contact] > 0.0)) {
    return pair;
  }
  const std::size_t normals = scene_.pairs[contact].normal.size();
  const std::size_t first = scene_.table.first[contact];
  const auto n = static_cast<Eigen::Index>(normals);
  pair.slip = base::Vector::Zero(n);
  pair.path = base::Vector::Zero(n);
  for (std::size_t i = 0; i < normals; ++i) {
    const auto at = static_cast<Eigen::Index>(i);
    pair.touch.push_back(touch_[first + i]);
    pair.slip[at] = slip_[first + normals + i];
    pair.path[at] = path_[first + normals + i];
  }
  pair.work = work_[contact];
  pair.mu = mu_[contact];
  return pair;
}

void FrictionHistory::begin(std::size_t contact) {
  for (std::size_t r = scene_.table.first[contact]; r < scene_.table.first[contact + 1]; ++r) {
    slip_[r] = 0.0;
    path_[r] = 0.0;
  }
  std::fill(touch_.begin(), touch_.end(), solve::Touch::stick);
}

} // namespace spricka::run
