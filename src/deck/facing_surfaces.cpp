// SPDX-License-Identifier: GPL-3.0-or-later
#include "deck/facing_surfaces.hpp"

#include "base/by_dimension.hpp"
#include "geometry/polyline.hpp"
#include "mesh/boundary.hpp"

#include <algorithm>
#include <iterator>
#include <limits>
#include <map>

#include <Eigen/Geometry>

namespace spricka::deck {

namespace {

using base::Vec3;

/// The corners of a side and their middle.
struct SideCorners {
  std::vector<base::NodeId> nodes;
  std::vector<Vec3> x;
  Vec3 middle = Vec3::Zero();

  SideCorners(const model::Mesh& mesh, const model::Face& face) {
    const auto face_nodes = mesh::face_nodes(mesh, face); // holds what the loop goes through
    for (const base::NodeId n : face_nodes.corner_nodes()) {
      nodes.push_back(n);
      x.push_back(mesh.x[n.index()]);
      middle += x.back();
    }
    middle /= static_cast<double>(nodes.size());
  }
};

std::vector<SideCorners> sides_of(const model::Mesh& mesh, const Faces& faces) {
  std::vector<SideCorners> sides;
  for (const model::Face& face : faces) {
    sides.emplace_back(mesh, face);
  }
  return sides;
}

std::size_t nearest_middle(const std::vector<SideCorners>& sides, const Vec3& x) {
  const auto nearest = std::ranges::min_element(
      sides, {}, [&](const SideCorners& side) { return (side.middle - x).squaredNorm(); });
  return static_cast<std::size_t>(nearest - sides.begin());
}

// In the plane: whether the nearest point of the partner is no end of it; `uses`: sides at each of
// its nodes, one at an end.
bool faces_chain(const Vec3& x, const std::vector<SideCorners>& opposite_sides,
                 const std::map<base::NodeId, int>& uses) {
  double nearest = std::numeric_limits<double>::max();
  bool opposite = false;
  for (const SideCorners& other : opposite_sides) {
    const auto [t, distance] = geometry::nearest_point<3>(x, other.x[0], other.x[1]);
    if (distance < nearest) {
      nearest = distance;
      opposite = (t > 0.0 && t < 1.0) || uses.at(other.nodes[t > 0.5 ? 1 : 0]) > 1;
    }
  }
  return opposite;
}

// In space: whether a place, moved along the normal of the nearest of the partner's faces, is no
// farther from the middle of that one than its corners are.
bool faces_side(const Vec3& x, const std::vector<SideCorners>& opposite_sides,
                const std::map<base::NodeId, int>& /*uses*/) {
  const SideCorners& other = opposite_sides[nearest_middle(opposite_sides, x)];
  const Vec3 n = (other.x[0] - other.middle).cross(other.x[1] - other.middle).normalized();
  double reach = 0.0;
  for (const Vec3& corner : other.x) {
    reach = std::max(reach, (corner - other.middle).norm());
  }
  const Vec3 off = x - other.middle;
  return (off - n.dot(off) * n).norm() < reach;
}

constexpr base::ByDimension faces_opposite{&faces_chain, &faces_side};

} // namespace

Faces sorted_set_faces(const model::Mesh& mesh, base::FaceSetId set) {
  Faces faces = mesh.set_with_id(set).faces;
  std::ranges::sort(faces);
  faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
  return faces;
}

Faces common_faces(const Faces& a, const Faces& b) {
  Faces both;
  std::ranges::set_intersection(a, b, std::back_inserter(both));
  return both;
}

Faces faces_with_all_corners_in(const model::Mesh& mesh, const Faces& faces,
                                const std::set<base::NodeId>& nodes) {
  Faces within;
  std::ranges::copy_if(faces, std::back_inserter(within), [&](const model::Face& face) {
    return std::ranges::all_of(SideCorners(mesh, face).nodes,
                               [&](base::NodeId n) { return nodes.contains(n); });
  });
  return within;
}

std::set<base::NodeId> face_corner_nodes(const model::Mesh& mesh, const Faces& faces) {
  std::set<base::NodeId> nodes;
  for (const SideCorners& side : sides_of(mesh, faces)) {
    nodes.insert(side.nodes.begin(), side.nodes.end());
  }
  return nodes;
}

std::size_t doubly_paired_face_count(const model::Mesh& mesh, const FacingSurfaces& a,
                                     const FacingSurfaces& b) {
  const Faces shared = common_faces(a.one, b.one);
  const Faces opposite_faces = common_faces(a.two, b.two);
  if (shared.empty() || opposite_faces.empty()) {
    return 0;
  }
  Faces all;
  std::ranges::set_union(a.two, b.two, std::back_inserter(all));
  if (all.size() == opposite_faces.size()) {
    return shared.size();
  }
  const std::vector<SideCorners> sides = sides_of(mesh, all);
  return static_cast<std::size_t>(std::ranges::count_if(shared, [&](const model::Face& face) {
    const std::size_t nearest = nearest_middle(sides, SideCorners(mesh, face).middle);
    return std::ranges::binary_search(opposite_faces, all[nearest]);
  }));
}

std::size_t facing_face_count(const model::Mesh& mesh, const Faces& faces,
                              const Faces& opposite_faces) {
  if (opposite_faces.empty()) {
    return faces.size();
  }
  const std::vector<SideCorners> sides = sides_of(mesh, opposite_faces);
  std::map<base::NodeId, int> uses;
  for (const SideCorners& side : sides) {
    for (const base::NodeId n : side.nodes) {
      ++uses[n];
    }
  }
  return static_cast<std::size_t>(std::ranges::count_if(faces, [&](const model::Face& face) {
    return faces_opposite.at(mesh.dim)(SideCorners(mesh, face).middle, sides, uses);
  }));
}

} // namespace spricka::deck
