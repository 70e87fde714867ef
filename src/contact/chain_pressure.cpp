// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/chain_pressure.hpp"

#include "contact/arc.hpp"
#include "contact/axis_ends.hpp"
#include "contact/push_only.hpp"
#include "contact/slave_places.hpp"
#include "contact/smooth.hpp"
#include "shape/quadrature.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <span>
#include <utility>

#include <Eigen/SparseCholesky>

namespace spricka::contact {

using base::at;
using base::index;

namespace {

constexpr int surface_degree = 7; // of products of shape functions on an edge or half of one
constexpr double covered = 1e-4;  // of a hat's area: what integration may miss
constexpr double no_hat = 1e-9;   // of a hat's area

// Surface mass matrix C = sum over edges of integral N N^T, times the depth.
Eigen::SparseMatrix<double> surface_mass(const PairConstraints& pair, const Numbering& number) {
  std::vector<Eigen::Triplet<double>> entries;
  for (const geometry::ElementSide& edge : pair.contact.facets) {
    edge.for_quadrature_points(surface_degree, [&](const Vec2& r, double weight) {
      const geometry::SideValues N = edge.N(r);
      const geometry::SidePoint at = edge.point(r);
      const double w = weight * at.area_vector().norm() *
                       out_of_plane_depth(pair.contact, pair.target, at.x.head<2>());
      for (std::size_t i = 0; i < edge.nodes.size(); ++i) {
        for (std::size_t j = 0; j < edge.nodes.size(); ++j) {
          entries.emplace_back(number.at(edge.nodes[i]), number.at(edge.nodes[j]),
                               w * N[index(i)] * N[index(j)]);
        }
      }
    });
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
  for (const ChainRange& chain : node_ranges_of_chains(surface)) {
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
  const std::vector<double> starts = chain_start_lengths(surface);
  const std::vector<ChainRange> chains = node_ranges_of_chains(surface);
  for (std::size_t c = 0; c < chains.size(); ++c) {
    for (std::size_t i = 0; i < chains[c].count; ++i) {
      places[chains[c].first + i].at.arc += starts[c];
    }
  }
}

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
    const std::array<double, 3> N = edge_shape_functions(edge, xi);
    const std::array<double, 3> hat = edge_hat_values(edge, xi);
    const Vec2 here = surface_normal(surface, edge, xi);
    const double w = weight * edge_tangent(edge, xi).norm() *
                     out_of_plane_depth(surface, pair.target, point_on_edge(edge, xi));
    for (std::size_t i = 0; i < static_cast<std::size_t>(edge.count); ++i) {
      const Eigen::Index k = number.at(edge.nodes[i]);
      area.facing[k] += w * N[i] * here.dot(normal[at(k)]);
      area.hat[k] += w * hat[i];
    }
  };
  for (const Edge& edge : surface.plane.edges) {
    for (const double half : {-0.5, 0.5}) {
      for (const auto& [r, weight] : shape::line_rule(surface_degree)) {
        add(edge, half + 0.5 * r[0], 0.5 * weight);
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
NodalPressure recover(const PairConstraints& pair, const ContactRowValues& row,
                      const ContactSideNodalForces& force, const std::vector<RecoveryNode>& places,
                      const Numbering& number) {
  const auto n = index(number.size());
  base::Vector R = base::Vector::Zero(n);
  base::Vector T = base::Vector::Zero(n); // along the tangent, normal turned to the left
  for (const RecoveryNode& p : places) {
    const auto at = force.node.find(p.at.node);
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
    extrapolate_pressure_to_axis(pair.contact, number, p.lumped);
    extrapolate_pressure_to_axis(pair.contact, number, p.shear_lumped);
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
  filter_alternating_pressure(pair.contact, number, sound, p.consistent, p.lumped);
  if (!pair.tangent.empty()) { // shear is treated as pressure, so that their ratio keeps its bound
    for (std::size_t i = 0; i < pair.tangent.size(); ++i) {
      p.shear_consistent[number.at(pair.tangent[i].node)] =
          -row.lambda[index(pair.normal.size() + i)];
    }
    rim_pressure(pair, number, paired, p.shear_consistent, p.shear_lumped);
    filter_alternating_pressure(pair.contact, number, sound, p.shear_consistent, p.shear_lumped);
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

double recover_chain_pressure(const PairConstraints& pair, const ContactRowValues& rows,
                              const ContactSideNodalForces& force, PairPressure& result) {
  std::vector<RecoveryNode> places = ordered_places(pair.contact);
  mark_crack_faces(pair.contact, places);
  string_chains(pair.contact, places);
  Numbering number;
  for (const RecoveryNode& p : places) {
    number.try_emplace(p.at.node, index(number.size()));
  }
  const NodalPressure p = recover(pair, rows, force, places, number);
  std::map<base::NodeId, std::size_t> row_of;
  for (std::size_t i = 0; i < pair.normal.size(); ++i) {
    row_of[pair.normal[i].node] = i;
  }
  for (RecoveryNode& place : places) {
    const Eigen::Index k = number.at(place.at.node);
    place.at.p_lumped = p.lumped[k];
    place.at.p_consistent = p.consistent[k];
    place.at.q_lumped = p.shear_lumped[k];
    place.at.q_consistent = p.shear_consistent[k];
    if (const auto row = row_of.find(place.at.node); row != row_of.end()) {
      rows.assign_row_to_node(pair, row->second, place.at);
    }
    result.nodes.push_back(place.at);
  }
  copy_mid_node_state_to_axis(pair, row_of, result.nodes);
  if (pair.faces) {
    close_tips(result.nodes);
  }
  const double area = contact_area(pair, result.nodes);
  SurfaceInterval arc = find_longest_closed_arc(pair.contact, result.nodes, pair.segments);
  if (std::ranges::any_of(result.nodes, &NodePressure::closed)) {
    convert_to_slave_coordinates(pair, result.nodes, arc);
  } else {
    SurfaceInterval nothing;
    convert_to_slave_coordinates(pair, result.nodes, nothing);
  }
  result.arc_from = arc.from;
  result.arc_to = arc.to;
  return area;
}

} // namespace spricka::contact
