// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/node_pairing.hpp"

#include "contact/node_pair.hpp"
#include "contact/rigid_target.hpp"
#include "contact/space/opposite.hpp"
#include "shape/quadrature.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include <fmt/format.h>

namespace spricka::contact {

namespace {

constexpr double off_normal = 1e-3; // of the mean edge length
// About an axis the corner of a quadratic edge that lies on the axis has no area: no force acts
// there, and its row would say nothing. Share of the square of the mean edge length.
constexpr double no_area = 1e-9;

// A node with the sum of its edges' normals and its share of their area.
struct SurfaceNode {
  Vec2 x = Vec2::Zero();
  Vec2 normal = Vec2::Zero();
  double area = 0.0;
};

// In the order of the chains, so that rows run along the surface.
struct OrderedSurfaceNodes {
  std::map<base::NodeId, SurfaceNode> node;
  std::vector<base::NodeId> order;
};

// Integral of each shape function over an edge times the depth there: what a uniform pressure puts
// on the nodes. Three Gauss points: exact on straight edges, about an axis as well.
std::array<double, 3> nodal_areas(const Edge& edge, const PairConstraints& pair) {
  std::array<double, 3> area{};
  for (const auto& [r, weight] : shape::line_rule(5)) {
    const std::array<double, 3> N = edge_N(edge, r[0]);
    const double w = weight * tangent_on(edge, r[0]).norm() *
                     out_of_plane_depth(pair.contact, pair.target, point_on(edge, r[0]));
    for (std::size_t i = 0; i < area.size(); ++i) {
      area[i] += w * N[i];
    }
  }
  return area;
}

OrderedSurfaceNodes collect(const ContactSurface& surface, const PairConstraints& pair) {
  OrderedSurfaceNodes all;
  for (const Edge& edge : surface.plane.edges) {
    const std::array<double, 3> xi{-1.0, 1.0, 0.0};
    const std::array<double, 3> area = nodal_areas(edge, pair);
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
      at->second.area += area[i];
    }
  }
  return all;
}

// What a node has opposite: a node, or a point of a rigid target.
struct OppositePoint {
  base::NodeId node; ///< invalid on a rigid target
  Vec2 normal = Vec2::Zero();
  double gap = 0.0;
};

std::optional<OppositePoint> rigid_opposite(const SurfaceNode& node, const PairConstraints& pair) {
  const std::optional<RigidProjection> foot = normal_projection(*pair.rigid, node.x);
  if (!foot || foot->beyond || node.normal.dot(foot->normal) <= 0.0 ||
      std::abs(foot->gap) > farthest_opposite * pair.contact.extent) {
    return std::nullopt;
  }
  return OppositePoint{base::NodeId(), foot->normal, foot->gap};
}

std::optional<OppositePoint> opposite(const SurfaceNode& node, const OrderedSurfaceNodes& targets,
                                      const ContactSurface& contact) {
  const Vec2 n = node.normal.normalized();
  double best = std::numeric_limits<double>::infinity();
  std::optional<OppositePoint> found;
  for (const base::NodeId id : targets.order) {
    const SurfaceNode& other = targets.node.at(id);
    const Vec2 d = other.x - node.x;
    const double along = d.dot(n);
    const double across = std::abs(n.x() * d.y() - n.y() * d.x());
    if (other.normal.dot(n) < 0.0 && across <= off_normal * contact.mean_length &&
        std::abs(along) <= farthest_opposite * contact.extent && std::abs(along) < best) {
      best = std::abs(along);
      found = OppositePoint{id, n, along};
    }
  }
  return found;
}

} // namespace

void node_rows(PairConstraints& pair, std::optional<double> declared_gap, bool tangents) {
  const OrderedSurfaceNodes nodes = collect(pair.contact, pair);
  const OrderedSurfaceNodes targets = collect(pair.target, pair);
  int lonely = 0;
  for (const base::NodeId id : nodes.order) {
    const SurfaceNode& node = nodes.node.at(id);
    const std::optional<OppositePoint> other =
        pair.rigid ? rigid_opposite(node, pair) : opposite(node, targets, pair.contact);
    if (!other) {
      lonely += pair.rigid ? 0 : 1; // beyond a rigid target there is nothing
      continue;
    }
    pair.found = true;
    const Vec2& n = other->normal;
    if (pair.contact.axial &&
        node.area <= no_area * pair.contact.mean_length * pair.contact.mean_length) {
      continue;
    }
    const Vec2 push = node.area * n;
    append_node_rows(
        NodePair{id, other->node, base::to_space(push), node.area,
                 declared_gap.value_or(zero_round_off(other->gap, node.x.cwiseAbs().maxCoeff()))},
        tangents, pair);
  }
  if (pair.found && lonely > 0) {
    pair.trouble = fmt::format("PAIRING=NODE needs a master node opposite each slave node; {} of "
                               "{} slave nodes have none (use PAIRING=SEGMENT)",
                               lonely, nodes.order.size());
  }
}

} // namespace spricka::contact
