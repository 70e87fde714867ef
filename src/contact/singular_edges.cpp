// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/singular_edges.hpp"

#include "base/by_dimension.hpp"
#include "base/disjoint_sets.hpp"
#include "base/index.hpp"
#include "contact/pair_points.hpp"
#include "contact/rigid_target.hpp"
#include "contact/space/surface_projection.hpp"
#include "geometry/polyline.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <set>
#include <tuple>
#include <utility>

namespace spricka::contact {

using base::index;

namespace {

constexpr double at_node = 1e-6; // in xi, or of an edge's length
constexpr double together = 0.1; // of an edge's length in space
constexpr double softer = 10.0; // a corner of a body on one that much stiffer bears no more than it
constexpr double lifted = 1e-3; // of an edge's length: a place just within the face

// A place where a surface of a pair may end.
struct SurfaceEnd {
  Vec3 x = Vec3::Zero();
  std::vector<base::NodeId> nodes; ///< of the contact surface, whose pressure acts there
  bool contact_ends = false;
  bool target_ends = false;
  bool bounded = false;
};

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
  const Vec2 x = point_on_edge(edge, xi);
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
  const std::array<double, 3> phi = edge_hat_values(edge, xi);
  std::vector<base::NodeId> nodes;
  for (std::size_t i = 0; i < static_cast<std::size_t>(edge.count); ++i) {
    if (phi[i] > at_node) {
      nodes.push_back(edge.nodes[i]);
    }
  }
  return nodes;
}

std::vector<SurfaceEnd> ends_of_edges(const PairConstraints& pair) {
  const std::vector<EdgeEnds> edges = edges_with_ends(pair.contact);
  const std::vector<EdgeEnds> targets = edges_with_ends(pair.target);
  std::vector<SurfaceEnd> ends;
  for (const MortarSegment& s : find_mortar_segments(pair)) {
    const EdgeEnds& own = edges[s.contact_edge];
    for (const bool upward : {false, true}) {
      const double xi = upward ? s.to : s.from;
      ends.push_back({.x = base::embed_in_space(point_on_edge(*own.edge, xi)),
                      .nodes = nodes_at(*own.edge, xi),
                      .contact_ends = (upward ? own.open_last : own.open_first) &&
                                      std::abs(xi - (upward ? 1.0 : -1.0)) < at_node,
                      .target_ends = target_ends(pair, targets, *own.edge, s, xi)});
    }
  }
  return ends;
}

// A side of a face with no neighbour in its smooth part.
struct PartBoundaryEdge {
  std::size_t face = 0;
  std::vector<base::NodeId> nodes; ///< both corners, then the middle if there is one
  std::array<Vec3, 3> x;           ///< corner, middle, corner
  Vec3 inside = Vec3::Zero();      ///< a place of the face beside the middle
  Vec3 normal = Vec3::Zero();      ///< of the face there
  double length = 0.0;
};

PartBoundaryEdge boundary_edge(const FacetSurface& surface, std::size_t f, int corner) {
  const geometry::ElementSide& face = surface.facets[f];
  const int corners = face.corner_count();
  const int next = (corner + 1) % corners;
  PartBoundaryEdge edge;
  edge.face = f;
  edge.nodes = {face.nodes[static_cast<std::size_t>(corner)],
                face.nodes[static_cast<std::size_t>(next)]};
  if (static_cast<int>(face.nodes.size()) >= 2 * corners) {
    edge.nodes.push_back(face.nodes[static_cast<std::size_t>(corners + corner)]);
  }
  const Vec2 middle =
      0.5 * (face.node_local_coordinates(corner) + face.node_local_coordinates(next));
  edge.x = {face.X.col(corner), face.position(middle), face.X.col(next)};
  edge.length = (edge.x[2] - edge.x[0]).norm();
  const geometry::SidePoint at = face.point(middle + lifted * (face.domain_centre() - middle));
  edge.inside = at.x;
  edge.normal = surface_normal(surface, f, at);
  return edge;
}

// The boundaries of all smooth parts.
std::vector<PartBoundaryEdge> part_boundary(const FacetSurface& surface) {
  std::map<std::tuple<std::size_t, base::NodeId, base::NodeId>, int> met;
  const auto each_side = [&](const auto& visit) {
    for (std::size_t f = 0; f < surface.facets.size(); ++f) {
      const int corners = surface.facets[f].corner_count();
      for (int i = 0; i < corners; ++i) {
        const auto [a, b] =
            std::minmax(surface.facets[f].nodes[static_cast<std::size_t>(i)],
                        surface.facets[f].nodes[static_cast<std::size_t>((i + 1) % corners)]);
        visit(f, i, std::tuple(surface.part[f], a, b));
      }
    }
  };
  each_side([&](std::size_t, int, const auto& key) { ++met[key]; });
  std::vector<PartBoundaryEdge> edges;
  each_side([&](std::size_t f, int i, const auto& key) {
    if (met.at(key) == 1) {
      edges.push_back(boundary_edge(surface, f, i));
    }
  });
  return edges;
}

// The boundaries of a surface in a tree, to ask whether it ends at a place.
class PartBoundaryTree {
public:
  explicit PartBoundaryTree(const std::vector<PartBoundaryEdge>& edges)
      : edges_(edges), tree_(boxes(edges)) {}

  [[nodiscard]] bool at(const Vec3& x, double near) const {
    return std::ranges::any_of(tree_.boxes_within(x, near), [&](std::size_t i) {
      const std::array<Vec3, 3>& y = edges_[i].x;
      return std::min(geometry::distance_to_segment(x, y[0], y[1]),
                      geometry::distance_to_segment(x, y[1], y[2])) < near;
    });
  }

private:
  static std::vector<geometry::Box<3>> boxes(const std::vector<PartBoundaryEdge>& edges) {
    std::vector<geometry::Box<3>> all;
    all.reserve(edges.size());
    for (const PartBoundaryEdge& edge : edges) {
      all.push_back(geometry::Box<3>::around(edge.x));
    }
    return all;
  }
  const std::vector<PartBoundaryEdge>& edges_;
  geometry::BoxTree<3> tree_;
};

std::vector<SurfaceEnd> ends_of_faces(const PairConstraints& pair) {
  // Rigid shapes have no end: a body's corner on one is of a right angle or less.
  if (pair.rigid_shape || !pair.segments) {
    return {};
  }
  const FacetSurface& own = pair.contact;
  const FacetSurface& other = pair.target;
  const std::vector<PartBoundaryEdge> own_edges = part_boundary(own);
  const std::vector<PartBoundaryEdge> other_edges = part_boundary(other);
  const PartBoundaryTree own_ends(own_edges);
  const PartBoundaryTree other_ends(other_edges);
  std::vector<SurfaceEnd> ends;
  const SurfaceProjector from_own(own, other);
  for (const PartBoundaryEdge& edge : own_edges) {
    if (const auto met = from_own.project_along_normal(edge.inside, edge.normal)) {
      const Vec3 opposite = edge.inside + met->gap * edge.normal;
      ends.push_back({edge.x[1], edge.nodes, true, other_ends.at(opposite, together * edge.length),
                      softer * pair.contact.stiffness < pair.target.stiffness});
    }
  }
  const SurfaceProjector from_other(other, own);
  for (const PartBoundaryEdge& edge : other_edges) {
    if (const auto met = from_other.project_along_normal(edge.inside, edge.normal)) {
      const Vec3 opposite = edge.inside + met->gap * edge.normal;
      ends.push_back({edge.x[1], own.facets[met->target].nodes,
                      own_ends.at(opposite, together * edge.length), true,
                      softer * pair.target.stiffness < pair.contact.stiffness});
    }
  }
  return ends;
}

// Ends at one place, less than `near` apart, are one edge, as the two crack faces of a mouth;
// without `near` those that have nodes in common.
std::vector<SingularContactEdge> joined(const std::vector<SurfaceEnd>& places,
                                        std::optional<double> near) {
  std::map<base::NodeId, std::size_t> edge_of;
  base::DisjointSets sets(places.size());
  for (std::size_t i = 0; i < places.size(); ++i) {
    for (std::size_t k = 0; near && k < i; ++k) {
      if ((places[k].x - places[i].x).norm() < *near) {
        sets.join_sets(k, i);
      }
    }
    for (std::size_t n = 0; !near && n < places[i].nodes.size(); ++n) {
      sets.join_sets(edge_of.try_emplace(places[i].nodes[n], i).first->second, i);
    }
  }
  std::map<std::size_t, SingularContactEdge> ends;
  std::map<std::size_t, std::set<base::NodeId>> nodes;
  for (std::size_t i = 0; i < places.size(); ++i) {
    const auto end =
        ends.try_emplace(sets.root(i), SingularContactEdge{places[i].x, {}, true, near.has_value()})
            .first;
    end->second.bounded = end->second.bounded && places[i].bounded;
    nodes[sets.root(i)].insert(places[i].nodes.begin(), places[i].nodes.end());
  }
  std::vector<SingularContactEdge> all;
  for (auto& [at, end] : ends) {
    end.nodes.assign(nodes.at(at).begin(), nodes.at(at).end());
    all.push_back(std::move(end));
  }
  return all;
}

/// How ends are found, and how near to each other they are one edge (of the mean size).
struct EndSearch {
  std::vector<SurfaceEnd> (*find)(const PairConstraints&);
  std::optional<double> near;
};
constexpr base::ByDimension<EndSearch> end_searches{{ends_of_edges, at_node},
                                                    {ends_of_faces, std::nullopt}};

} // namespace

std::vector<SingularContactEdge> find_singular_edges(const PairConstraints& pair) {
  if (pair.faces) {
    return {};
  }
  const auto& [find, near] = end_searches.at(pair.contact.dim);
  std::vector<SurfaceEnd> ends = find(pair);
  // A target that ends where another begins is a crack mouth. What ends by distance or by turning
  // away is open there; a body's corner on a rigid target is one of a right angle or less.
  std::erase_if(ends, [&](const SurfaceEnd& end) {
    return end.contact_ends == end.target_ends || (end.contact_ends && pair.rigid);
  });
  return joined(ends, near ? std::optional(*near * pair.contact.mean_size) : std::nullopt);
}

} // namespace spricka::contact
