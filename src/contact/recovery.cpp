// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/recovery.hpp"

#include "base/index.hpp"
#include "contact/arc.hpp"
#include "contact/axis_ends.hpp"
#include "contact/push_only.hpp"
#include "contact/slave_places.hpp"
#include "contact/smooth.hpp"
#include "contact/space_recovery.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <unordered_map>

#include <Eigen/SparseCholesky>

namespace spricka::contact {

using base::at;
using base::index;

namespace {

// Gauss-Legendre; the weights of shape::line_rule differ from these in the last bits.
constexpr std::array<double, 4> gauss_r{-0.8611363115940526, -0.3399810435848563,
                                        0.3399810435848563, 0.8611363115940526};
constexpr std::array<double, 4> gauss_w{0.3478548451374538, 0.6521451548625461, 0.6521451548625461,
                                        0.3478548451374538};

constexpr double covered = 1e-4; // of a hat's area: what integration may miss
constexpr double no_hat = 1e-9;  // of a hat's area

// Surface mass matrix C = sum over edges of integral N N^T, times the depth.
Eigen::SparseMatrix<double> surface_mass(const PairConstraints& pair, const Numbering& number) {
  std::vector<Eigen::Triplet<double>> entries;
  const auto add = [&](const Edge& edge, double xi, double weight) {
    const std::array<double, 3> N = edge_N(edge, xi);
    const double w = weight * tangent_on(edge, xi).norm() *
                     out_of_plane_depth(pair.contact, pair.target, point_on(edge, xi));
    for (std::size_t i = 0; i < static_cast<std::size_t>(edge.count); ++i) {
      for (std::size_t j = 0; j < static_cast<std::size_t>(edge.count); ++j) {
        entries.emplace_back(number.at(edge.nodes[i]), number.at(edge.nodes[j]), w * N[i] * N[j]);
      }
    }
  };
  for (const Edge& edge : pair.contact.plane.edges) {
    for (std::size_t g = 0; g < gauss_r.size(); ++g) {
      add(edge, gauss_r[g], gauss_w[g]);
    }
  }
  const auto n = index(number.size());
  Eigen::SparseMatrix<double> C(n, n);
  C.setFromTriplets(entries.begin(), entries.end());
  return C;
}

// Nodes of the surface chain by chain in running order, with their place and mean normal.
struct RecoveryNode {
  NodePressure at;
  Vec2 normal = Vec2::Zero();
};

void append_chain(const ContactSurface& surface, const EdgeChain& chain,
                  std::vector<RecoveryNode>& places) {
  const std::span<const Edge> edges = surface.plane.edges_of_chain(chain);
  const std::size_t first = places.size();
  double arc = 0.0;
  const auto add = [&](const Edge& edge, std::size_t i, double xi, double s) {
    RecoveryNode p;
    p.at.node = edge.nodes[i];
    p.at.x.head<2>() = edge.x[i];
    p.at.arc = s;
    p.normal = surface_normal(surface, edge, xi);
    places.push_back(p);
  };
  for (std::size_t e = 0; e < edges.size(); ++e) {
    const Edge& edge = edges[e];
    add(edge, 0, -1.0, arc);
    if (e > 0) {
      places.back().normal += surface_normal(surface, edges[e - 1], 1.0);
    }
    if (edge.count == 3) {
      add(edge, 2, 0.0, arc + 0.5 * edge.length);
    }
    arc += edge.length;
  }
  const Edge& last = edges.back();
  if (chain.closed) {
    places[first].normal += surface_normal(surface, last, 1.0);
  } else {
    add(last, 1, 1.0, arc);
  }
}

std::vector<RecoveryNode> ordered_places(const ContactSurface& surface) {
  std::vector<RecoveryNode> places;
  for (const EdgeChain& chain : surface.plane.chains) {
    append_chain(surface, chain, places);
  }
  for (RecoveryNode& p : places) {
    p.normal.normalize();
    if (surface.circle) {
      const Vec2 d = p.at.x.head<2>() - surface.circle->centre;
      p.at.theta = std::atan2(d.y(), d.x());
    }
  }
  return places;
}

// A crack mouth cuts the surface: two nodes of different numbers stand in one point.
void mark_crack_faces(const ContactSurface& surface, std::vector<RecoveryNode>& places) {
  std::vector<std::size_t> ends;
  for (const ChainRange& chain : chain_ranges(surface)) {
    if (!chain.closed) {
      ends.push_back(chain.first);
      ends.push_back(chain.first + chain.count - 1);
    }
  }
  for (const std::size_t a : ends) {
    for (const std::size_t b : ends) {
      if (a != b && (places[a].at.x - places[b].at.x).norm() < 1e-9 * surface.extent) {
        // A chain that starts here lies ahead of the mouth, one that ends here behind it.
        places[a].at.crack_face = places[a].at.arc == 0.0 ? 1 : -1;
      }
    }
  }
}

// Chain after chain: lengths along the whole surface.
void string_chains(const ContactSurface& surface, std::vector<RecoveryNode>& places) {
  const std::vector<double> starts = chain_starts(surface);
  const std::vector<ChainRange> chains = chain_ranges(surface);
  for (std::size_t c = 0; c < chains.size(); ++c) {
    for (std::size_t i = 0; i < chains[c].count; ++i) {
      places[chains[c].first + i].at.arc += starts[c];
    }
  }
}

// Nodal force vectors of the contact side, and the total on it.
struct SideForce {
  std::unordered_map<std::int32_t, base::Vec3> node;
  base::Vec3 total = base::Vec3::Zero();
};

SideForce side_force(const PairConstraints& pair, const base::Vector& lambda,
                     const Numbering& number) {
  SideForce force;
  const auto add = [&](const ConstraintRow& row, double value) {
    for (const RowEntry& entry : row.entries) {
      if (number.contains(entry.node)) {
        force.node.try_emplace(entry.node.value, base::Vec3::Zero()).first->second +=
            value * entry.weight;
        force.total += value * entry.weight;
      }
    }
  };
  for (std::size_t i = 0; i < pair.normal.size(); ++i) {
    add(pair.normal[i], lambda[index(i)]);
  }
  for (std::size_t i = 0; i < pair.tangent.size(); ++i) {
    add(pair.tangent[i], lambda[index(pair.normal.size() + i)]);
  }
  return force;
}

// Of the normal rows first, then of tangents.
struct Multipliers {
  const base::Vector& lambda;
  const std::vector<bool>& closed;
  bool may_pull = false;
};

struct NodalPressure {
  base::Vector lumped, consistent;
  base::Vector shear_lumped, shear_consistent;
};

// Integrals over each node's edges: of its shape function times the cosine between the normal there
// and the node's own, and of its hat.
struct NodeArea {
  base::Vector facing, hat;
};

NodeArea node_areas(const PairConstraints& pair, const std::vector<RecoveryNode>& places,
                    const Numbering& number) {
  const ContactSurface& surface = pair.contact;
  const auto n = index(number.size());
  NodeArea area{base::Vector::Zero(n), base::Vector::Zero(n)};
  std::vector<Vec2> normal(number.size());
  for (const RecoveryNode& p : places) {
    normal[at(number.at(p.at.node))] = p.normal;
  }
  const auto add = [&](const Edge& edge, double xi, double weight) {
    const std::array<double, 3> N = edge_N(edge, xi);
    const std::array<double, 3> hat = edge_hats(edge, xi);
    const Vec2 here = surface_normal(surface, edge, xi);
    const double w = weight * tangent_on(edge, xi).norm() *
                     out_of_plane_depth(surface, pair.target, point_on(edge, xi));
    for (std::size_t i = 0; i < static_cast<std::size_t>(edge.count); ++i) {
      const Eigen::Index k = number.at(edge.nodes[i]);
      area.facing[k] += w * N[i] * here.dot(normal[at(k)]);
      area.hat[k] += w * hat[i];
    }
  };
  for (const Edge& edge : surface.plane.edges) {
    for (const double half : {-0.5, 0.5}) {
      for (std::size_t g = 0; g < gauss_r.size(); ++g) {
        add(edge, half + 0.5 * gauss_r[g], 0.5 * gauss_w[g]);
      }
    }
  }
  return area;
}

// Edges that face the other surface with their whole length and, if asked, are closed at every
// node, chain by chain.
std::vector<bool> whole_edges(const PairConstraints& pair, const base::Vector& hat,
                              const Numbering& number, const std::vector<bool>* closed) {
  std::vector<bool> good(number.size(), false);
  for (std::size_t i = 0; i < pair.normal.size(); ++i) {
    const Eigen::Index k = number.at(pair.normal[i].node);
    good[at(k)] =
        std::abs(pair.normal[i].area - hat[k]) <= covered * hat[k] && (!closed || (*closed)[i]);
  }
  std::vector<bool> whole;
  for (const Edge& edge : pair.contact.plane.edges) {
    whole.push_back(std::all_of(edge.nodes.begin(), edge.nodes.begin() + edge.count,
                                [&](base::NodeId node) { return good[at(number.at(node))]; }));
  }
  return whole;
}

// A node at the rim of the paired part has the pressure of its row: its force belongs to a part of
// its area only.
void rim_pressure(const PairConstraints& pair, const Numbering& number,
                  const std::vector<bool>& whole, const base::Vector& lambda,
                  base::Vector& pressure) {
  std::size_t e = 0;
  for (const Edge& edge : pair.contact.plane.edges) {
    for (std::size_t i = 0; i < static_cast<std::size_t>(edge.count) && !whole[e]; ++i) {
      pressure[number.at(edge.nodes[i])] = lambda[number.at(edge.nodes[i])];
    }
    ++e;
  }
}

// The corner function of a quadratic edge has no first moment about its node, so the lumped
// pressure is right to second order even where edges of different length meet; the second moment
// meets the turn of the normal, which the facing areas count.
NodalPressure recover(const PairConstraints& pair, const Multipliers& row, const SideForce& force,
                      const std::vector<RecoveryNode>& places, const Numbering& number) {
  const auto n = index(number.size());
  base::Vector R = base::Vector::Zero(n);
  base::Vector T = base::Vector::Zero(n); // along the tangent, normal turned to the left
  for (const RecoveryNode& p : places) {
    const auto at = force.node.find(p.at.node.value);
    if (at != force.node.end()) {
      R[number.at(p.at.node)] = 0.0 - at->second.head<2>().dot(p.normal);
      T[number.at(p.at.node)] = at->second.head<2>().dot(Vec2(-p.normal.y(), p.normal.x()));
    }
  }
  NodeArea area = node_areas(pair, places, number);
  for (Eigen::Index k = 0; pair.faces && k < n; ++k) {
    // at a crack's tip, beside a quarter point, the corner's function has no area
    area.facing[k] = area.facing[k] > no_hat * area.hat[k] ? area.facing[k] : area.hat[k];
  }
  NodalPressure p{R.cwiseQuotient(area.facing), base::Vector::Zero(n), T.cwiseQuotient(area.facing),
                  base::Vector::Zero(n)};
  if (pair.contact.axial) {
    extrapolate_to_axis(pair.contact, number, p.lumped);
    extrapolate_to_axis(pair.contact, number, p.shear_lumped);
  }
  std::vector<Eigen::Index> order;
  order.reserve(places.size());
  for (const RecoveryNode& place : places) {
    order.push_back(number.at(place.at.node));
  }
  if (!pair.segments) {
    const Eigen::SparseMatrix<double> C = surface_mass(pair, number);
    const base::Vector lump = C * base::Vector::Ones(n);
    const Eigen::SimplicialLLT<Eigen::SparseMatrix<double>> factor(C);
    p.consistent = factor.solve(p.lumped.cwiseProduct(lump));
    if (!pair.tangent.empty()) {
      p.shear_consistent = factor.solve(p.shear_lumped.cwiseProduct(lump));
    }
    if (!row.may_pull) { // the consistent one oscillates where contact ends
      redistribute_tension(pair.contact, order, lump, {p.consistent, p.shear_consistent});
      redistribute_tension(pair.contact, order, area.facing, {p.lumped, p.shear_lumped});
    }
    return p;
  }
  for (std::size_t i = 0; i < pair.normal.size(); ++i) {
    p.consistent[number.at(pair.normal[i].node)] = row.lambda[index(i)];
  }
  const std::vector<bool> paired = whole_edges(pair, area.hat, number, nullptr);
  const std::vector<bool> sound = whole_edges(pair, area.hat, number, &row.closed);
  rim_pressure(pair, number, paired, p.consistent, p.lumped);
  filter_pressure(pair.contact, number, sound, p.consistent, p.lumped);
  if (!pair.tangent.empty()) { // shear is treated as pressure, so that their ratio keeps its bound
    for (std::size_t i = 0; i < pair.tangent.size(); ++i) {
      p.shear_consistent[number.at(pair.tangent[i].node)] =
          -row.lambda[index(pair.normal.size() + i)];
    }
    rim_pressure(pair, number, paired, p.shear_consistent, p.shear_lumped);
    filter_pressure(pair.contact, number, sound, p.shear_consistent, p.shear_lumped);
  }
  if (!row.may_pull) { // corner functions are negative in part: a steep end pulls at a corner
    redistribute_tension(pair.contact, order, area.facing, {p.lumped, p.shear_lumped});
  }
  return p;
}

// A crack's tip has no row: it is as closed and as pressed as the node next to it.
void close_tips(std::vector<NodePressure>& nodes) {
  const std::size_t n = nodes.size();
  for (const auto& [tip, next] :
       {std::pair(std::size_t{0}, std::size_t{1}), std::pair(n - 1, n - 2)}) {
    if (n > 1 && nodes[tip].row < 0) {
      NodePressure& at = nodes[tip];
      at.closed = nodes[next].closed;
      at.p_lumped = nodes[next].p_lumped;
      at.q_lumped = nodes[next].q_lumped;
    }
  }
}

} // namespace

PairPressure recover_pressure(const PairConstraints& pair, const base::Vector& lambda,
                              const base::Vector& gap, const std::vector<bool>& closed,
                              bool may_pull) {
  if (!pair.functions.empty()) {
    return recover_space_pressure(pair, lambda, gap, closed);
  }
  std::vector<RecoveryNode> places = ordered_places(pair.contact);
  mark_crack_faces(pair.contact, places);
  string_chains(pair.contact, places);
  Numbering number;
  for (const RecoveryNode& p : places) {
    number.try_emplace(p.at.node, index(number.size()));
  }
  const SideForce force = side_force(pair, lambda, number);
  const NodalPressure p = recover(pair, {lambda, closed, may_pull}, force, places, number);

  PairPressure result;
  result.force_on_slave = pair.swapped ? base::Vec3(-force.total) : force.total;
  double thrust = 0.0;
  std::map<base::NodeId, std::size_t> row_of;
  for (std::size_t i = 0; i < pair.normal.size(); ++i) {
    const auto at = index(i);
    row_of[pair.normal[i].node] = i;
    thrust += lambda[at] * pair.normal[i].area;
    result.min_pressure = i == 0 ? lambda[at] : std::min(result.min_pressure, lambda[at]);
    result.max_pressure = std::max(result.max_pressure, lambda[at]);
    result.closed += closed[i] ? 1 : 0;
    result.max_penetration = std::max(result.max_penetration, -gap[at] / pair.normal[i].area);
  }
  for (RecoveryNode& place : places) {
    const Eigen::Index k = number.at(place.at.node);
    place.at.p_lumped = p.lumped[k];
    place.at.p_consistent = p.consistent[k];
    place.at.q_lumped = p.shear_lumped[k];
    place.at.q_consistent = p.shear_consistent[k];
    const auto row = row_of.find(place.at.node);
    if (row != row_of.end()) {
      place.at.row = static_cast<int>(row->second);
      place.at.closed = closed[row->second];
      place.at.gap = gap[index(row->second)] / pair.normal[row->second].area;
    }
    result.nodes.push_back(place.at);
  }
  copy_to_axis_ends(pair, row_of, result.nodes);
  if (pair.faces) {
    close_tips(result.nodes);
  }
  const double area = contact_area(pair, result.nodes);
  result.mean_pressure = area > 0.0 ? thrust / area : 0.0;
  ContactArc arc = longest_arc(pair.contact, result.nodes, pair.segments);
  if (std::ranges::any_of(result.nodes, &NodePressure::closed)) {
    to_slave_coordinates(pair, result.nodes, arc);
  } else {
    ContactArc nothing;
    to_slave_coordinates(pair, result.nodes, nothing);
  }
  result.arc_from = arc.from;
  result.arc_to = arc.to;
  return result;
}

} // namespace spricka::contact
