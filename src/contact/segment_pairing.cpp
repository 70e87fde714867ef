// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/segment_pairing.hpp"

#include "contact/rigid_target.hpp"
#include "contact/row_builder.hpp"
#include "contact/segment.hpp"
#include "shape/quadrature.hpp"

#include <algorithm>
#include <cmath>
#include <map>

namespace spricka::contact {

namespace {

constexpr int degree = 9;           // of the quadrature along a segment
constexpr double least_cover = 0.2; // rows covered by less go to a neighbour

struct Builders {
  std::map<base::NodeId, RowBuilder> normal;
  std::map<base::NodeId, RowBuilder> tangent;
};

// Adds one integration point: weight w includes the line element and the depth.
struct Point {
  const Edge& edge;
  const Edge& target;
  double xi, eta, w;
  Vec2 n;
  double gap, round_gap;
};

void add_point(const Point& p, bool tangents, Builders& rows) {
  const std::array<double, 3> phi = edge_hats(p.edge, p.xi);
  const std::array<double, 3> N = edge_N(p.edge, p.xi);
  const std::array<double, 3> M = edge_N(p.target, p.eta);
  const Vec2 t(-p.n.y(), p.n.x());
  for (int i = 0; i < p.edge.count; ++i) {
    const auto at = static_cast<std::size_t>(i);
    const double c = p.w * phi[at];
    if (c == 0.0) {
      continue;
    }
    RowBuilder& row = rows.normal[p.edge.nodes[at]];
    row.gap += c * p.gap;
    row.round_gap += c * p.round_gap;
    row.area += c;
    RowBuilder* slip = tangents ? &rows.tangent[p.edge.nodes[at]] : nullptr;
    if (slip != nullptr) {
      slip->area += c;
    }
    for (int j = 0; j < p.edge.count; ++j) {
      const auto k = static_cast<std::size_t>(j);
      row.add(p.edge.nodes[k], -c * N[k] * p.n);
      if (slip != nullptr) {
        slip->add(p.edge.nodes[k], -c * N[k] * t);
      }
    }
    for (int j = 0; j < p.target.count; ++j) {
      const auto k = static_cast<std::size_t>(j);
      row.add(p.target.nodes[k], c * M[k] * p.n);
      if (slip != nullptr) {
        slip->add(p.target.nodes[k], c * M[k] * t);
      }
    }
  }
}

// What a point of a contact edge sees on its normal, or on that of a rigid target.
struct Opposite {
  double eta = 0.0;
  Vec2 normal = Vec2::Zero();
  double gap = 0.0;
  double round_gap = 0.0; ///< of the circles that nodes lie on, where they do
};

// How far along n the circle that the nodes of a surface lie on is from a point of its edges.
double to_circle(const Surface& surface, const Vec2& x, const Vec2& n) {
  if (!surface.circle || !surface.circle->exact) {
    return 0.0;
  }
  const Vec2 d = x - surface.circle->centre;
  const double along = d.normalized().dot(n);
  return std::abs(along) < 0.5 ? 0.0 : (surface.circle->radius - d.norm()) / along;
}

std::optional<Opposite> opposite(const PairRows& pair, const Edge& edge, const Edge& target,
                                 double xi) {
  const Vec2 x = point_on(edge, xi);
  if (pair.rigid) {
    const std::optional<RigidFoot> foot = foot_on(*pair.rigid, x);
    if (!foot) {
      return std::nullopt;
    }
    const double gap = gap_beyond_digits(foot->gap, x);
    return Opposite{0.0, foot->normal, gap, gap - to_circle(pair.contact, x, foot->normal)};
  }
  const Vec2 n = surface_normal(pair.contact, edge, xi);
  const std::optional<double> eta = hit_on(target, x, n);
  if (!eta) {
    return std::nullopt;
  }
  const Vec2 y = point_on(target, *eta);
  const double gap = gap_beyond_digits((y - x).dot(n), x);
  return Opposite{*eta, n, gap, gap - to_circle(pair.contact, x, n) + to_circle(pair.target, y, n)};
}

// False if a point of the segment finds no target: its area would be lost.
bool add_segment(const PairRows& pair, const Edge& edge, const Edge& target, const Segment& s,
                 const std::optional<double>& declared, bool tangents, Builders& rows) {
  for (const auto& [r, weight] : shape::line_rule(degree)) {
    const double xi = 0.5 * ((s.to + s.from) + (s.to - s.from) * r[0]);
    const Vec2 x = point_on(edge, xi);
    const std::optional<Opposite> other = opposite(pair, edge, target, xi);
    if (!other) {
      return false;
    }
    const double w = 0.5 * (s.to - s.from) * weight * tangent_on(edge, xi).norm() *
                     depth_at(pair.contact, pair.target, x);
    const double gap = declared.value_or(other->gap);
    const double round_gap = declared.value_or(other->round_gap);
    add_point({edge, target, xi, other->eta, w, other->normal, gap, round_gap}, tangents, rows);
  }
  return true;
}

// What each function would weigh if its whole support were paired.
void add_support(const PairRows& pair, const Edge& edge, Builders& rows) {
  for (const double half : {-0.5, 0.5}) {
    for (const auto& [r, weight] : shape::line_rule(degree)) {
      const double xi = half + 0.5 * r[0];
      const std::array<double, 3> phi = edge_hats(edge, xi);
      const double w = 0.5 * weight * tangent_on(edge, xi).norm() *
                       depth_at(pair.contact, pair.target, point_on(edge, xi));
      for (int i = 0; i < edge.count; ++i) {
        rows.normal[edge.nodes[static_cast<std::size_t>(i)]].whole +=
            w * phi[static_cast<std::size_t>(i)];
      }
    }
  }
}

// A sliver of cover makes a row that weighs next to nothing: its function joins the neighbour's.
void merge_slivers(const std::vector<base::NodeId>& nodes, bool closed, bool tangents,
                   Builders& rows, int& merged) {
  const std::size_t n = nodes.size();
  const auto covered = [&](std::size_t i) {
    const RowBuilder& row = rows.normal[nodes[i]];
    return row.area >= least_cover * row.whole;
  };
  std::vector<bool> whole(n);
  for (std::size_t i = 0; i < n; ++i) {
    whole[i] = covered(i);
  }
  for (std::size_t i = 0; i < n; ++i) {
    if (whole[i] || rows.normal[nodes[i]].area <= 0.0) {
      continue;
    }
    const bool has_next = closed || i + 1 < n;
    const bool has_last = closed || i > 0;
    const std::size_t next = (i + 1) % n;
    const std::size_t last = (i + n - 1) % n;
    std::size_t to = n;
    // a narrow target before coarse edges has no whole neighbour: its slivers become one row
    const bool no_whole = !(has_next && whole[next]) && !(has_last && whole[last]);
    const bool onward = has_next && next > i && rows.normal[nodes[next]].area > 0.0;
    if ((has_next && whole[next]) || (no_whole && onward)) {
      to = next;
    } else if (!no_whole) {
      to = last;
    } else if (rows.normal[nodes[i]].area > 1e-9 * rows.normal[nodes[i]].whole) {
      continue; // no neighbour is any better: what is covered must hold
    }
    if (to < n) {
      rows.normal[nodes[to]].add(rows.normal[nodes[i]]);
      if (tangents) {
        rows.tangent[nodes[to]].add(rows.tangent[nodes[i]]);
      }
      ++merged;
    }
    rows.normal[nodes[i]] = RowBuilder{};
    rows.tangent.erase(nodes[i]);
  }
}

bool covered_twice(const std::vector<Segment>& segments) {
  for (std::size_t i = 1; i < segments.size(); ++i) {
    if (segments[i].contact_edge == segments[i - 1].contact_edge &&
        segments[i].from < segments[i - 1].to - 1e-6) {
      return true;
    }
  }
  return false;
}

} // namespace

void segment_rows(PairRows& pair, std::optional<double> declared_gap, bool tangents) {
  const std::vector<Segment> segments = pair.rigid ? find_segments(pair.contact, *pair.rigid)
                                                   : find_segments(pair.contact, pair.target);
  if (covered_twice(segments)) {
    pair.trouble = "the surfaces face each other twice at one place (folded or cornered surfaces "
                   "are not available in this version)";
    return;
  }
  pair.found = !segments.empty();
  pair.segments = true;
  const std::vector<Edge>& edges = pair.contact.plane.edges;
  const Edge nothing{{}, 0, {}, 0.0}; // a rigid target has no nodes
  const std::vector<Edge> targets = pair.rigid ? std::vector{nothing} : pair.target.plane.edges;
  Builders rows;
  for (const Edge& edge : edges) {
    add_support(pair, edge, rows);
  }
  for (const Segment& s : segments) {
    if (!add_segment(pair, edges[s.contact_edge], targets[s.target_edge], s, declared_gap, tangents,
                     rows)) {
      pair.trouble =
          "the normals of one surface miss the other within a stretch that faces it (too "
          "strongly curved for its edges?)";
      return;
    }
  }
  for (const EdgeChain& chain : pair.contact.plane.chains) {
    const std::vector<base::NodeId> nodes =
        ordered_nodes(pair.contact.plane.of(chain), chain.closed);
    merge_slivers(nodes, chain.closed, tangents, rows, pair.merged);
    for (const base::NodeId node : nodes) {
      if (rows.normal[node].area > 0.0) {
        pair.normal.push_back(rows.normal[node].finish(node, false));
        if (tangents) {
          pair.tangent.push_back(rows.tangent[node].finish(node, true));
        }
      }
    }
  }
}

} // namespace spricka::contact
