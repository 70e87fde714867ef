// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/make_rows.hpp"

#include <cmath>

namespace spricka::contact {

namespace {

constexpr double least_cover = 0.2; // rows covered by less go to a neighbour

// Adds c times what the point p moves along a direction, the target before the contact surface.
void add_motion(const MortarPoint& p, const geometry::ElementSide& facet,
                const geometry::ElementSide* target, double c, const base::Vec3& along,
                ConstraintRowBuilder& row) {
  const geometry::SideValues N = facet.N(p.r);
  for (std::size_t k = 0; k < facet.nodes.size(); ++k) {
    row.add_contribution(facet.nodes[k], -c * N[static_cast<Eigen::Index>(k)] * along);
  }
  if (target != nullptr) {
    const geometry::SideValues M = target->N(p.s);
    for (std::size_t k = 0; k < target->nodes.size(); ++k) {
      row.add_contribution(target->nodes[k], c * M[static_cast<Eigen::Index>(k)] * along);
    }
  }
}

void add_point(const MortarPoint& p, const geometry::ElementSide& facet,
               const geometry::ElementSide* target, int tangents, RowsByNode& rows) {
  const FacetValues phi = facet_hats(facet, p.r);
  for (std::size_t i = 0; i < facet.nodes.size(); ++i) {
    const double c = p.weight * phi[i];
    // Hats are zero over half edges: a node that nothing but zeros would be added to gets no row.
    if (c == 0.0) {
      continue;
    }
    NodalRowSums& row = rows[facet.nodes[i]];
    // (contact.2), and along the tangents (contact.21).
    row.normal.gap += c * p.gap;
    row.normal.round_gap += c * p.round_gap;
    row.normal.area += c;
    add_motion(p, facet, target, c, p.normal, row.normal);
    for (std::size_t t = 0; t < static_cast<std::size_t>(tangents); ++t) {
      row.tangent[t].area += c;
      add_motion(p, facet, target, c, p.tangent[t], row.tangent[t]);
    }
  }
}

bool is_covered(const ConstraintRowBuilder& row) {
  return row.area >= least_cover * row.whole;
}

} // namespace

RowsByNode integrate_mortar_rows(const MortarPoints& points,
                                 std::span<const geometry::ElementSide> contact,
                                 std::span<const geometry::ElementSide> targets, int tangents) {
  RowsByNode rows;
  // The area of each function over all of its edges, paired or not: the measure of its cover.
  for (const SurfaceQuadraturePoint& p : points.surface) {
    const geometry::ElementSide& facet = contact[p.facet];
    const FacetValues phi = facet_hats(facet, p.r);
    for (std::size_t i = 0; i < facet.nodes.size(); ++i) {
      rows[facet.nodes[i]].normal.whole += p.weight * phi[i];
    }
  }
  for (const MortarPoint& p : points.points) {
    add_point(p, contact[p.facet], targets.empty() ? nullptr : &targets[p.target], tangents, rows);
  }
  return rows;
}

int merge_slivers(const NodeOrder& order, RowsByNode& rows) {
  const std::vector<base::NodeId>& nodes = order.nodes;
  const std::size_t n = nodes.size();
  std::vector<bool> whole(n);
  for (std::size_t i = 0; i < n; ++i) {
    whole[i] = is_covered(rows[nodes[i]].normal);
  }
  int merged = 0;
  for (std::size_t i = 0; i < n; ++i) {
    if (whole[i] || rows[nodes[i]].normal.area <= 0.0) {
      continue;
    }
    const bool has_next = order.closed || i + 1 < n;
    const bool has_last = order.closed || i > 0;
    const std::size_t next = (i + 1) % n;
    const std::size_t last = (i + n - 1) % n;
    std::size_t to = n;
    // a narrow target before coarse edges has no whole neighbour: its slivers become one row
    const bool no_whole = !(has_next && whole[next]) && !(has_last && whole[last]);
    const bool onward = has_next && next > i && rows[nodes[next]].normal.area > 0.0;
    if ((has_next && whole[next]) || (no_whole && onward)) {
      to = next;
    } else if (!no_whole) {
      to = last;
    } else if (rows[nodes[i]].normal.area > 1e-9 * rows[nodes[i]].normal.whole) {
      continue; // no neighbour is any better: what is covered must hold
    }
    NodalRowSums& own = rows[nodes[i]];
    if (to < n) {
      NodalRowSums& other = rows[nodes[to]];
      other.normal.add_contribution(own.normal);
      for (std::size_t t = 0; t < own.tangent.size(); ++t) {
        other.tangent[t].add_contribution(own.tangent[t]);
      }
      ++merged;
    }
    // Merged, or a cover of round-off that is dropped: without area append_rows() leaves it out.
    own = NodalRowSums{};
  }
  return merged;
}

void append_rows(const NodeOrder& order, const RowsByNode& rows, int tangents,
                 PairConstraints& pair) {
  for (const base::NodeId node : order.nodes) {
    const auto row = rows.find(node);
    if (row == rows.end() || !(row->second.normal.area > 0.0)) {
      continue;
    }
    const auto normal = static_cast<int>(pair.normal.size());
    for (std::size_t t = 0; t < static_cast<std::size_t>(tangents); ++t) {
      pair.tangent.push_back(row->second.tangent[t].make_row(node, normal));
    }
    pair.normal.push_back(row->second.normal.make_row(node));
  }
}

} // namespace spricka::contact
