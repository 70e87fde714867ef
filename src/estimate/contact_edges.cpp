// SPDX-License-Identifier: GPL-3.0-or-later
#include "estimate/contact_edges.hpp"

#include "contact/segment.hpp"

#include <algorithm>
#include <cmath>

namespace spricka::estimate {

namespace {

constexpr double opposite_ends = 1e-2; // of the length of an edge, as node pairing has it
constexpr double whole = 0.99;         // of a target edge: faced all along

// Two edges that lie end on end run against each other, bodies on their left.
bool match(const contact::Edge& a, const contact::Edge& b, const contact::ContactSurface& surface) {
  for (const int end : {0, 1}) {
    const double xi = end == 0 ? -1.0 : 1.0;
    const base::Vec2 n = contact::surface_normal(surface, a, xi);
    const auto i = static_cast<std::size_t>(end);
    const base::Vec2 d = b.x[1 - i] - a.x[i];
    // Along the surface only: a gap or an interference does not keep edges from being opposite.
    if (std::abs(n.x() * d.y() - n.y() * d.x()) > opposite_ends * a.length) {
      return false;
    }
  }
  return true;
}

} // namespace

EdgeIndex index_boundary_edges(const EdgeTable& table) {
  EdgeIndex index;
  for (std::size_t e = 0; e < table.edges.size(); ++e) {
    if (table.edges[e].elements == 1) {
      index.emplace(table.edges[e].nodes, e);
    }
  }
  return index;
}

std::optional<std::size_t> find_mesh_edge(const EdgeIndex& index, const contact::Edge& edge) {
  if (edge.count < 3) {
    return std::nullopt;
  }
  const auto at = index.find({std::min(edge.nodes[0], edge.nodes[1]),
                              std::max(edge.nodes[0], edge.nodes[1]), edge.nodes[2]});
  return at == index.end() ? std::nullopt : std::optional<std::size_t>(at->second);
}

std::vector<ContactEdge> contact_edges_of_pair(const EdgeTable& table,
                                               const contact::PairConstraints& pair) {
  const EdgeIndex index = index_boundary_edges(table);
  const std::map<base::NodeId, std::size_t> row_of = contact::map_nodes_to_normal_rows(pair);
  const std::vector<contact::Edge>& own = pair.contact.plane.edges;
  const std::vector<contact::Edge>& others = pair.target.plane.edges;
  std::vector<ContactEdge> result(own.size() + others.size());
  std::vector<bool> known(result.size(), false);
  for (std::size_t i = 0; i < result.size(); ++i) {
    const bool target = i >= own.size();
    const contact::Edge& edge = target ? others[i - own.size()] : own[i];
    if (const std::optional<std::size_t> at = find_mesh_edge(index, edge)) {
      known[i] = true;
      result[i].edge = *at;
      result[i].shape = &edge;
      result[i].target_side = target;
    }
    // Rows belong to nodes of the contact side; a target edge gets those of the edges that it
    // faces.
    for (int n = 0; n < edge.count && !target; ++n) {
      const auto row = row_of.find(edge.nodes[static_cast<std::size_t>(n)]);
      if (row != row_of.end()) {
        result[i].rows.push_back(row->second);
      }
    }
    result[i].covered = !target && result[i].rows.size() >= 2;
  }
  if (!pair.rigid) {
    std::vector<double> faced(others.size(), 0.0);
    for (const contact::MortarSegment& s :
         contact::find_mortar_segments(pair.contact, pair.target)) {
      ContactEdge& a = result[s.contact_edge];
      ContactEdge& b = result[own.size() + s.target_edge];
      const contact::Edge& ea = own[s.contact_edge];
      const contact::Edge& eb = others[s.target_edge];
      b.rows.insert(b.rows.end(), a.rows.begin(), a.rows.end());
      // Segments are stretches of the contact edge, which is 2 long in its own coordinate.
      faced[s.target_edge] += 0.5 * (s.to - s.from) * ea.length / eb.length;
      if (known[s.contact_edge] && known[own.size() + s.target_edge] &&
          match(ea, eb, pair.contact)) {
        a.opposite = b.edge;
        // The edges run against each other: the end of one lies on the start of the other.
        a.same_way = (ea.nodes[0] < ea.nodes[1]) == (eb.nodes[1] < eb.nodes[0]) ? 1.0 : -1.0;
      }
    }
    for (std::size_t i = 0; i < others.size(); ++i) {
      ContactEdge& b = result[own.size() + i];
      std::sort(b.rows.begin(), b.rows.end());
      b.rows.erase(std::unique(b.rows.begin(), b.rows.end()), b.rows.end());
      // Curved edges that face each other differ in length a little: 1 is not met exactly.
      b.covered = faced[i] > whole;
    }
  }
  std::vector<ContactEdge> found;
  for (std::size_t i = 0; i < result.size(); ++i) {
    if (known[i]) {
      found.push_back(std::move(result[i]));
    }
  }
  return found;
}

void add_closed_edges(const std::vector<ContactEdge>& edges, const contact::PairConstraints& pair,
                      const std::vector<bool>& closed, bool bonded,
                      std::vector<ClosedContactEdge>& result) {
  const bool loaded = pair.segments && !pair.rigid && !pair.faces && !bonded;
  for (const ContactEdge& edge : edges) {
    if (edge.covered && !edge.rows.empty() &&
        std::ranges::all_of(edge.rows, [&](std::size_t r) { return bonded || closed[r]; })) {
      result.push_back({.at = &edge,
                        .bonded = bonded,
                        .support = pair.contact.stiffness / pair.target.stiffness,
                        .loaded = loaded && edge.target_side && !edge.opposite});
    }
  }
}

} // namespace spricka::estimate
