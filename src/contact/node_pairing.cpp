// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/node_pairing.hpp"

#include "contact/row_builder.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include <fmt/format.h>

namespace spricka::contact {

namespace {

constexpr double off_normal = 1e-3; // of the mean edge length
constexpr double far_share = 0.2;   // of the contact surface's extent

// A node with the sum of its edges' normals and its share of their area.
struct SurfaceNode {
  Vec2 x = Vec2::Zero();
  Vec2 normal = Vec2::Zero();
  double area = 0.0;
};

// In the order of the chains, so that rows run along the surface.
struct SurfaceNodes {
  std::map<base::NodeId, SurfaceNode> node;
  std::vector<base::NodeId> order;
};

SurfaceNodes collect(const Surface& surface, double thickness) {
  SurfaceNodes all;
  for (const EdgeChain& chain : surface.chains) {
    for (const Edge& edge : chain.edges) {
      const bool curved = edge.count == 3;
      const std::array<double, 3> xi{-1.0, 1.0, 0.0};
      const std::array<double, 3> share =
          curved ? std::array{1.0 / 6.0, 1.0 / 6.0, 4.0 / 6.0} : std::array{0.5, 0.5, 0.0};
      for (const std::size_t i : {std::size_t{0}, std::size_t{2}, std::size_t{1}}) {
        if (static_cast<int>(i) >= edge.count) {
          continue;
        }
        const auto [at, fresh] = all.node.try_emplace(edge.nodes[i]);
        if (fresh) {
          all.order.push_back(edge.nodes[i]);
        }
        at->second.x = edge.x[i];
        at->second.normal += surface_normal(surface, edge, xi[i]);
        at->second.area += share[i] * edge.length * thickness;
      }
    }
  }
  return all;
}

std::optional<base::NodeId> partner(const SurfaceNode& node, const Vec2& n,
                                    const SurfaceNodes& targets, const Surface& contact) {
  double best = std::numeric_limits<double>::infinity();
  std::optional<base::NodeId> found;
  for (const base::NodeId id : targets.order) {
    const SurfaceNode& other = targets.node.at(id);
    const Vec2 d = other.x - node.x;
    const double along = d.dot(n);
    const double across = std::abs(n.x() * d.y() - n.y() * d.x());
    if (other.normal.dot(n) < 0.0 && across <= off_normal * contact.mean_length &&
        std::abs(along) <= far_share * contact.extent && std::abs(along) < best) {
      best = std::abs(along);
      found = id;
    }
  }
  return found;
}

} // namespace

void node_rows(PairRows& pair, std::optional<double> declared_gap, bool tangents) {
  const double thickness = std::min(pair.contact.thickness, pair.target.thickness);
  const SurfaceNodes nodes = collect(pair.contact, thickness);
  const SurfaceNodes targets = collect(pair.target, thickness);
  int lonely = 0;
  for (const base::NodeId id : nodes.order) {
    const SurfaceNode& node = nodes.node.at(id);
    const Vec2 n = node.normal.normalized();
    const std::optional<base::NodeId> other = partner(node, n, targets, pair.contact);
    if (!other) {
      ++lonely;
      continue;
    }
    pair.found = true;
    const double gap = declared_gap ? *declared_gap : (targets.node.at(*other).x - node.x).dot(n);
    RowBuilder row;
    row.add(id, -node.area * n);
    row.add(*other, node.area * n);
    row.gap = node.area * gap;
    row.area = node.area;
    pair.normal.push_back(row.finish(id, false));
    if (tangents) {
      const Vec2 t(-n.y(), n.x());
      RowBuilder slip;
      slip.add(id, -node.area * t);
      slip.add(*other, node.area * t);
      slip.area = node.area;
      pair.tangent.push_back(slip.finish(id, true));
    }
  }
  if (pair.found && lonely > 0) {
    pair.trouble = fmt::format("PAIRING=NODE needs a master node opposite each slave node; {} of "
                               "{} slave nodes have none (use PAIRING=SEGMENT)",
                               lonely, nodes.order.size());
  }
}

} // namespace spricka::contact
