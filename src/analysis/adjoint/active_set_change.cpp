// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/adjoint/active_set_change.hpp"

#include "analysis/steps/row_opening.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

namespace spricka::analysis {

namespace {

// Pivots below this share of the largest belong to redundant rows.
constexpr double no_pivot = 1e-10;

struct ActiveSetCandidate {
  std::size_t pair = 0;
  std::size_t local = 0; ///< normal row of the pair
  std::size_t row = 0;   ///< of the table
  bool closed = false;
  bool end = false;   ///< beside an end of a closed stretch
  bool sharp = false; ///< closed at an edge of one surface
};

std::map<base::NodeId, base::Vec2> node_places(const contact::ContactSurface& surface) {
  std::map<base::NodeId, base::Vec2> place;
  for (const contact::Edge& edge : surface.plane.edges) {
    for (std::size_t i = 0; i < static_cast<std::size_t>(edge.count); ++i) {
      place.emplace(edge.nodes[i], edge.x[i]);
    }
  }
  return place;
}

// Node spacing of the surface's edge that is nearest to x.
double spacing_at(const contact::ContactSurface& surface, const base::Vec2& x) {
  double closest = std::numeric_limits<double>::infinity();
  double spacing = 0.0;
  for (const contact::Edge& edge : surface.plane.edges) {
    for (const double xi : {-1.0, 0.0, 1.0}) {
      const double distance = (contact::point_on_edge(edge, xi) - x).norm();
      if (distance < closest) {
        closest = distance;
        spacing = 0.5 * edge.length;
      }
    }
  }
  return spacing;
}

// Closed rows that lie nearer to an edge of one surface than the coarser surface has nodes there:
// it does not see how the pressure is spread among them.
std::vector<bool> beside_sharp_ends(const contact::PairConstraints& pair,
                                    const std::vector<bool>& closed) {
  std::vector<bool> beside(pair.normal.size(), false);
  if (pair.sharp_ends.empty()) {
    return beside;
  }
  const std::map<base::NodeId, base::Vec2> place = node_places(pair.contact);
  for (const contact::SingularContactEdge& end : pair.sharp_ends) {
    // A node that stands one spacing off does not count, whatever round-off makes of its place.
    constexpr double within = 0.99;
    const double reach = within * std::max(spacing_at(pair.contact, end.x.head<2>()),
                                           spacing_at(pair.target, end.x.head<2>()));
    for (std::size_t r = 0; r < beside.size(); ++r) {
      const base::NodeId node = pair.normal[r].node;
      const bool own = std::ranges::find(end.nodes, node) != end.nodes.end();
      if (closed[r] && (own || (place.at(node) - end.x.head<2>()).norm() < reach)) {
        beside[r] = true;
      }
    }
  }
  return beside;
}

// Normal rows on both sides of each change between closed and open along the surfaces, and those
// at edges of one surface.
void add_candidates(const Discretisation& scene, const StepState& state, std::size_t c,
                    std::vector<ActiveSetCandidate>& found) {
  const contact::PairConstraints& pair = scene.pairs[c];
  const std::map<base::NodeId, std::size_t> row_of = contact::map_nodes_to_normal_rows(pair);
  std::vector<bool> ends(pair.normal.size(), false);
  const std::vector<bool>& closed = state.pair_closed[c];
  for (const contact::Edge& edge : pair.contact.plane.edges) {
    // Neighbours along the edge: nodes 0 and 1 are its ends, 2 is its middle.
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
  const std::vector<bool> sharp = beside_sharp_ends(pair, closed);
  for (std::size_t r = 0; r < ends.size(); ++r) {
    if (ends[r] || sharp[r]) {
      found.push_back({.pair = c,
                       .local = r,
                       .row = scene.table.first[c] + r,
                       .closed = closed[r],
                       .end = ends[r],
                       .sharp = sharp[r]});
    }
  }
}

} // namespace

ContactEdgeKChange active_set_K_changes(const Discretisation& scene, const StepState& state,
                                        const StressIntensityAdjoints& adjoint,
                                        const contact::FixedActiveSet* held) {
  const Eigen::Index count = scene.k_layout().count();
  ContactEdgeKChange changes{base::Vector::Zero(count), base::Vector::Zero(count)};
  std::vector<ActiveSetCandidate> candidates;
  for (std::size_t c = 0; c < scene.pairs.size(); ++c) {
    // Bonded rows have no other state, and with friction there is no adjoint.
    if (state.mounted[c] && scene.pairs[c].tangent.empty()) {
      add_candidates(scene, state, c, candidates);
    }
  }
  if (candidates.empty() || held == nullptr || !held->is_consistent()) {
    return changes;
  }
  std::vector<std::size_t> rows;
  rows.reserve(candidates.size());
  for (const ActiveSetCandidate& c : candidates) {
    rows.push_back(c.row);
  }
  const base::Vector pivot = held->row_pivots(rows);
  std::array<double, 2> largest{}; // of the pivots of open and closed rows, which differ in unit
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    double& most = largest[candidates[i].closed ? 1 : 0];
    most = std::max(most, pivot[static_cast<Eigen::Index>(i)]);
  }
  // What a unit of force on an open row does to K (sensitivity.13).
  const auto by_force = [&](const ActiveSetCandidate& c, Eigen::Index k) {
    return row_opening(scene.contact_row(c.row), scene.cracked.mesh.dim, adjoint.z.col(k)) +
           adjoint.by_force(static_cast<Eigen::Index>(c.row), k);
  };
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    const ActiveSetCandidate& c = candidates[i];
    const double p = pivot[static_cast<Eigen::Index>(i)];
    if (!(p > no_pivot * largest[c.closed ? 1 : 0])) {
      continue;
    }
    const auto local = static_cast<Eigen::Index>(c.local);
    // Exact while all other rows stay as they are (estimate.13).
    for (Eigen::Index k = 0; k < count; ++k) {
      const double change = c.closed ? adjoint.w(static_cast<Eigen::Index>(c.row), k) *
                                           state.pair_lambda[c.pair][local] / p
                                     : -state.pair_gap[c.pair][local] / p * by_force(c, k);
      if (c.end) {
        changes.ends[k] = std::max(changes.ends[k], std::abs(change));
      }
      if (c.sharp) {
        changes.sharp[k] += std::abs(change);
      }
    }
  }
  return changes;
}

} // namespace spricka::analysis
