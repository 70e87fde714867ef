// SPDX-License-Identifier: GPL-3.0-or-later
#include "run/contact_flip.hpp"

#include <algorithm>
#include <cmath>
#include <map>

namespace spricka::run {

namespace {

// Pivots below this share of the largest belong to redundant rows.
constexpr double no_pivot = 1e-10;

struct Candidate {
  std::size_t pair = 0;
  std::size_t local = 0; ///< normal row of the pair
  std::size_t row = 0;   ///< of the table
  bool closed = false;
};

// Normal rows on both sides of each change between closed and open along the surfaces.
void add_ends(const Scene& scene, const StepState& state, std::size_t c,
              std::vector<Candidate>& found) {
  const contact::PairRows& pair = scene.pairs[c];
  std::map<base::NodeId, std::size_t> row_of;
  for (std::size_t r = 0; r < pair.normal.size(); ++r) {
    row_of.emplace(pair.normal[r].node, r);
  }
  std::vector<bool> ends(pair.normal.size(), false);
  const std::vector<bool>& closed = state.pair_closed[c];
  for (const contact::EdgeChain& chain : pair.contact.chains) {
    for (const contact::Edge& edge : chain.edges) {
      const std::size_t last = edge.count == 3 ? 2 : 1;
      const std::array<std::array<std::size_t, 2>, 2> steps{{{0, last}, {last, 1}}};
      for (std::size_t i = 0; i < (edge.count == 3 ? 2U : 1U); ++i) {
        const auto a = row_of.find(edge.nodes[steps[i][0]]);
        const auto b = row_of.find(edge.nodes[steps[i][1]]);
        if (a != row_of.end() && b != row_of.end() && closed[a->second] != closed[b->second]) {
          ends[a->second] = ends[b->second] = true;
        }
      }
    }
  }
  for (std::size_t r = 0; r < ends.size(); ++r) {
    if (ends[r]) {
      found.push_back({c, r, scene.table.first[c] + r, closed[r]});
    }
  }
}

double opening(const contact::ConstraintRow& row, int dim, const base::Matrix& z, Eigen::Index k) {
  double sum = 0.0;
  for (const contact::RowEntry& entry : row.entries) {
    sum += entry.weight.head(dim).dot(
        z.col(k).segment(static_cast<Eigen::Index>(entry.node.index()) * dim, dim));
  }
  return sum;
}

} // namespace

std::vector<base::Vec2> contact_flips(const Scene& scene, const StepState& state,
                                      const std::vector<estimate::Adjoint>& adjoints,
                                      const contact::HeldContact* held) {
  std::vector<base::Vec2> flips(adjoints.size(), base::Vec2::Zero());
  std::vector<Candidate> candidates;
  for (std::size_t c = 0; c < scene.pairs.size(); ++c) {
    if (state.mounted[c] && scene.pairs[c].tangent.empty()) {
      add_ends(scene, state, c, candidates);
    }
  }
  if (candidates.empty() || held == nullptr || !held->ok()) {
    return flips;
  }
  std::vector<std::size_t> rows;
  for (const Candidate& c : candidates) {
    rows.push_back(c.row);
  }
  const base::Vector pivot = held->pivots(rows);
  std::array<double, 2> largest{}; // of the pivots of open and closed rows, which differ in unit
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    double& most = largest[candidates[i].closed ? 1 : 0];
    most = std::max(most, pivot[static_cast<Eigen::Index>(i)]);
  }
  const auto by_force = [&](const Candidate& c, std::size_t t, Eigen::Index k) {
    return opening(*scene.table.rows[c.row], scene.cracked.mesh.dim, adjoints[t].z, k) +
           adjoints[t].by_force(static_cast<Eigen::Index>(c.row), k);
  };
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    const Candidate& c = candidates[i];
    const double p = pivot[static_cast<Eigen::Index>(i)];
    if (!(p > no_pivot * largest[c.closed ? 1 : 0])) {
      continue;
    }
    const auto local = static_cast<Eigen::Index>(c.local);
    for (std::size_t t = 0; t < adjoints.size(); ++t) {
      for (Eigen::Index k = 0; k < 2; ++k) {
        const double change = c.closed ? adjoints[t].w(static_cast<Eigen::Index>(c.row), k) *
                                             state.pair_lambda[c.pair][local] / p
                                       : -state.pair_gap[c.pair][local] / p * by_force(c, t, k);
        flips[t][k] = std::max(flips[t][k], std::abs(change));
      }
    }
  }
  return flips;
}

} // namespace spricka::run
