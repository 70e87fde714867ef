// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/sharp_end.hpp"

#include "contact/rigid_target.hpp"
#include "contact/segment.hpp"

#include <algorithm>
#include <cmath>

namespace spricka::contact {

namespace {

constexpr double at_node = 1e-6; // in xi, or of an edge's length

// Where the edges of a surface meet no other edge of it.
struct EdgeEnds {
  const Edge* edge = nullptr;
  bool open_first = false; ///< xi = -1 ends the chain
  bool open_last = false;
};

std::vector<EdgeEnds> edges_with_ends(const ContactSurface& surface) {
  std::vector<EdgeEnds> all;
  for (const EdgeChain& chain : surface.plane.chains) {
    const std::span<const Edge> edges = surface.plane.edges_of_chain(chain);
    for (std::size_t i = 0; i < edges.size(); ++i) {
      all.push_back({&edges[i], !chain.closed && i == 0, !chain.closed && i + 1 == edges.size()});
    }
  }
  return all;
}

// Whether the target's surface ends opposite a point of a contact edge.
bool target_ends(const PairConstraints& pair, const std::vector<EdgeEnds>& targets,
                 const Edge& edge, const MortarSegment& s, double xi) {
  const Vec2 x = point_on(edge, xi);
  if (pair.rigid) {
    const std::optional<RigidProjection> foot = normal_projection(*pair.rigid, x);
    const double near = at_node * edge.length;
    return foot && pair.rigid->shape == model::RigidTargetShape::line &&
           std::min((foot->point - pair.rigid->first.head<2>()).norm(),
                    (foot->point - pair.rigid->second.head<2>()).norm()) < near;
  }
  const EdgeEnds& target = targets[s.target_edge];
  const std::optional<double> eta =
      ray_intersection(*target.edge, x, surface_normal(pair.contact, edge, xi));
  return eta && ((target.open_first && std::abs(*eta + 1.0) < 10.0 * at_node) ||
                 (target.open_last && std::abs(*eta - 1.0) < 10.0 * at_node));
}

std::vector<base::NodeId> nodes_at(const Edge& edge, double xi) {
  const std::array<double, 3> phi = edge_hats(edge, xi);
  std::vector<base::NodeId> nodes;
  for (std::size_t i = 0; i < static_cast<std::size_t>(edge.count); ++i) {
    if (phi[i] > at_node) {
      nodes.push_back(edge.nodes[i]);
    }
  }
  return nodes;
}

// The two crack faces of a mouth are one place.
void add_end(std::vector<SingularContactEdge>& ends, const ContactSurface& contact,
             const SingularContactEdge& end) {
  const auto same = std::find_if(ends.begin(), ends.end(), [&](const SingularContactEdge& other) {
    return (other.x - end.x).norm() < at_node * contact.mean_length;
  });
  if (same == ends.end()) {
    ends.push_back(end);
  } else {
    same->nodes.insert(same->nodes.end(), end.nodes.begin(), end.nodes.end());
  }
}

} // namespace

std::vector<SingularContactEdge> find_singular_edges(const PairConstraints& pair) {
  const auto closed = [](const ContactSurface& surface) {
    return std::ranges::all_of(surface.plane.chains, &EdgeChain::closed);
  };
  if (pair.faces || (!pair.rigid && closed(pair.contact) && closed(pair.target))) {
    return {};
  }
  const std::vector<MortarSegment> segments = pair.rigid ? find_segments(pair.contact, *pair.rigid)
                                                         : find_segments(pair.contact, pair.target);
  const std::vector<EdgeEnds> edges = edges_with_ends(pair.contact);
  const std::vector<EdgeEnds> targets = edges_with_ends(pair.target);
  std::vector<SingularContactEdge> ends;
  for (const MortarSegment& s : segments) {
    const EdgeEnds& own = edges[s.contact_edge];
    for (const bool upward : {false, true}) {
      const double xi = upward ? s.to : s.from;
      const bool own_ends = (upward ? own.open_last : own.open_first) &&
                            std::abs(xi - (upward ? 1.0 : -1.0)) < at_node;
      const bool other_ends = target_ends(pair, targets, *own.edge, s, xi);
      // A target that ends where another begins is a crack mouth. What ends by distance or by
      // turning away is open there; a body's corner on a rigid target is one of a right angle or
      // less.
      if (own_ends ? !other_ends && !pair.rigid : other_ends) {
        const Vec2 x = point_on(*own.edge, xi);
        add_end(ends, pair.contact, {base::to_space(x), nodes_at(*own.edge, xi), false});
      }
    }
  }
  return ends;
}

} // namespace spricka::contact
