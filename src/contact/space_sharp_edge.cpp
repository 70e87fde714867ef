// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/space_sharp_edge.hpp"

#include "base/index.hpp"
#include "contact/space/surface_projection.hpp"
#include "geometry/polyline.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <numeric>
#include <optional>
#include <set>
#include <tuple>
#include <utility>

namespace spricka::contact {

using base::index;

namespace {

constexpr double together = 0.1; // of an edge's length
constexpr double softer = 10.0; // a corner of a body on one that much stiffer bears no more than it
constexpr double lifted = 1e-3; // of an edge's length: a place just within the face

// A side of a face with no neighbour in its smooth part.
struct PartBoundaryEdge {
  std::size_t face = 0;
  std::vector<base::NodeId> nodes; ///< both corners, then the middle if there is one
  std::array<Vec3, 3> x;           ///< corner, middle, corner
  Vec3 inside = Vec3::Zero();      ///< a place of the face beside the middle
  Vec3 normal = Vec3::Zero();      ///< of the face there
  double length = 0.0;
};

PartBoundaryEdge rim_of(const SpaceSurface& surface, std::size_t f, int corner) {
  const geometry::ElementSide& face = surface.faces[f];
  const int corners = face.corners();
  const int next = (corner + 1) % corners;
  PartBoundaryEdge rim;
  rim.face = f;
  rim.nodes = {face.nodes[static_cast<std::size_t>(corner)],
               face.nodes[static_cast<std::size_t>(next)]};
  if (static_cast<int>(face.nodes.size()) >= 2 * corners) {
    rim.nodes.push_back(face.nodes[static_cast<std::size_t>(corners + corner)]);
  }
  const Vec2 middle = 0.5 * (face.node_coordinates(corner) + face.node_coordinates(next));
  rim.x = {face.X.col(corner), face.position(middle), face.X.col(next)};
  rim.length = (rim.x[2] - rim.x[0]).norm();
  const geometry::SidePoint at = face.point(middle + lifted * (face.centre() - middle));
  rim.inside = at.x;
  rim.normal = surface_normal(surface, f, at);
  return rim;
}

// The rims of all smooth parts.
std::vector<PartBoundaryEdge> rims_of(const SpaceSurface& surface) {
  std::map<std::tuple<std::size_t, base::NodeId, base::NodeId>, int> met;
  const auto each_side = [&](const auto& visit) {
    for (std::size_t f = 0; f < surface.faces.size(); ++f) {
      const int corners = surface.faces[f].corners();
      for (int i = 0; i < corners; ++i) {
        const auto [a, b] =
            std::minmax(surface.faces[f].nodes[static_cast<std::size_t>(i)],
                        surface.faces[f].nodes[static_cast<std::size_t>((i + 1) % corners)]);
        visit(f, i, std::tuple(surface.part[f], a, b));
      }
    }
  };
  each_side([&](std::size_t, int, const auto& key) { ++met[key]; });
  std::vector<PartBoundaryEdge> rims;
  each_side([&](std::size_t f, int i, const auto& key) {
    if (met.at(key) == 1) {
      rims.push_back(rim_of(surface, f, i));
    }
  });
  return rims;
}

// The rims of a surface in a tree, to ask whether it ends at a place.
class PartBoundaryTree {
public:
  explicit PartBoundaryTree(const std::vector<PartBoundaryEdge>& rims)
      : rims_(rims), tree_(boxes(rims)) {}

  [[nodiscard]] bool at(const Vec3& x, double near) const {
    return std::ranges::any_of(tree_.boxes_within(x, near), [&](std::size_t i) {
      const std::array<Vec3, 3>& y = rims_[i].x;
      return std::min(geometry::distance_to_segment(x, y[0], y[1]),
                      geometry::distance_to_segment(x, y[1], y[2])) < near;
    });
  }

private:
  static std::vector<geometry::Box<3>> boxes(const std::vector<PartBoundaryEdge>& rims) {
    std::vector<geometry::Box<3>> all;
    all.reserve(rims.size());
    for (const PartBoundaryEdge& rim : rims) {
      all.push_back(geometry::Box<3>::around(rim.x));
    }
    return all;
  }
  const std::vector<PartBoundaryEdge>& rims_;
  geometry::BoxTree<3> tree_;
};

// Nodes of the contact surface whose pressure acts at an edge of one of the two.
struct AtEdge {
  Vec3 x;
  std::vector<base::NodeId> nodes;
  bool bounded = false;
};

// Places that have nodes in common are one edge.
std::vector<SingularContactEdge> joined(const std::vector<AtEdge>& places) {
  std::map<base::NodeId, std::size_t> edge_of;
  std::vector<std::size_t> root(places.size());
  std::iota(root.begin(), root.end(), std::size_t{0});
  const auto find = [&](std::size_t i) {
    while (root[i] != i) {
      i = root[i] = root[root[i]];
    }
    return i;
  };
  for (std::size_t i = 0; i < places.size(); ++i) {
    for (const base::NodeId n : places[i].nodes) {
      const auto [at, fresh] = edge_of.try_emplace(n, i);
      if (!fresh) {
        const std::size_t a = find(at->second);
        const std::size_t b = find(i);
        root[std::max(a, b)] = std::min(a, b);
      }
    }
  }
  std::map<std::size_t, SingularContactEdge> ends;
  std::map<std::size_t, std::set<base::NodeId>> nodes;
  for (std::size_t i = 0; i < places.size(); ++i) {
    const auto end = ends.try_emplace(find(i), SingularContactEdge{places[i].x, {}, true}).first;
    end->second.bounded = end->second.bounded && places[i].bounded;
    nodes[find(i)].insert(places[i].nodes.begin(), places[i].nodes.end());
  }
  std::vector<SingularContactEdge> all;
  for (auto& [at, end] : ends) {
    end.nodes.assign(nodes.at(at).begin(), nodes.at(at).end());
    all.push_back(std::move(end));
  }
  return all;
}

} // namespace

std::vector<SingularContactEdge> find_space_singular_edges(const PairConstraints& pair) {
  if (pair.rigid_shape) { // without end: a body's corner on it is of a right angle or less
    return {};
  }
  const SpaceSurface& own = pair.contact.space;
  const SpaceSurface& other = pair.target.space;
  const std::vector<PartBoundaryEdge> own_rims = rims_of(own);
  const std::vector<PartBoundaryEdge> other_rims = rims_of(other);
  const PartBoundaryTree own_ends(own_rims);
  const PartBoundaryTree other_ends(other_rims);
  std::vector<AtEdge> places;
  const SurfaceProjection from_own(own, other);
  for (const PartBoundaryEdge& rim : own_rims) {
    const std::optional<ProjectionPoint> met =
        from_own.project_along_normal(rim.inside, rim.normal);
    if (met && !other_ends.at(rim.inside + met->gap * rim.normal, together * rim.length)) {
      places.push_back(
          {rim.x[1], rim.nodes, softer * pair.contact.stiffness < pair.target.stiffness});
    }
  }
  const SurfaceProjection from_other(other, own);
  for (const PartBoundaryEdge& rim : other_rims) {
    const std::optional<ProjectionPoint> met =
        from_other.project_along_normal(rim.inside, rim.normal);
    if (met && !own_ends.at(rim.inside + met->gap * rim.normal, together * rim.length)) {
      places.push_back({rim.x[1], own.faces[met->target].nodes,
                        softer * pair.target.stiffness < pair.contact.stiffness});
    }
  }
  return joined(places);
}

} // namespace spricka::contact
