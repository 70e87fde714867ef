// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/tube/solid_cavity.hpp"

#include "base/disjoint_sets.hpp"
#include "geometry/box.hpp"
#include "mesh/plane.hpp"

#include <algorithm>
#include <limits>
#include <map>
#include <set>
#include <utility>

namespace spricka::mesh {
namespace {

using base::ElementId;
using base::NodeId;
using base::Vec3;

/// Clear of a tube, in its radii from the front; of a crack's faces, in sizes of their elements.
constexpr double clear_of_tube = 1.7;
constexpr double clear_of_faces = 0.5;

class Digger {
public:
  Digger(const SolidHostMesh& host, const CrackFrame& frame,
         std::span<const CrackDistanceField> cracks)
      : host_(host), mesh_(host.mesh()), frame_(frame), cracks_(cracks),
        in_(mesh_.element_count(), false) {}

  SolidCavity build_cavities(std::span<const ElementId> seeds) {
    part_ = host_.property_part_index(seeds.front());
    take_wanted(seeds);
    constexpr int passes = 60;
    for (int pass = 0; pass < passes; ++pass) {
      find_outline();
      if (!take_pinched()) {
        break;
      }
    }
    SolidCavity cavity;
    if (!bad_) {
      cavity.elements = taken();
      cavity.shells = shells();
    } else {
      cavity.trouble = "the body has edges or nodes that its surface meets twice";
    }
    return cavity;
  }

private:
  using EdgeKey = std::pair<NodeId, NodeId>;

  [[nodiscard]] bool wanted(ElementId e) const {
    const SolidHostMesh::ElementBoundingBall& extent = host_.bounding_ball(e);
    const Vec3 middle = frame_.rounded_local_coordinates(extent.middle);
    const double radius = extent.radius / frame_.a;
    const double edge = extent.edge / frame_.a;
    return std::ranges::any_of(cracks_, [&](const CrackDistanceField& crack) {
      const double away = (middle - crack.centre()).norm() - crack.radius() - radius;
      // Nothing about the crack is larger than itself.
      if (away > std::max(edge, crack.radius())) {
        return false;
      }
      const CrackDistanceField::DistancesFromCrack d = crack.distance(middle);
      if (d.front < radius + clear_of_tube * d.radius + coordinate_tolerance ||
          d.surface < radius + clear_of_faces * FillSizes().size_at(d) + coordinate_tolerance) {
        return true;
      }
      double nearest = d.front;
      for (const NodeId n : mesh_.element_nodes(e)) {
        nearest = std::min(
            nearest, crack.distance(frame_.rounded_local_coordinates(mesh_.x[n.index()])).front);
      }
      return edge > nearest + d.radius + coordinate_tolerance;
    });
  }

  void take_wanted(std::span<const ElementId> seeds) {
    std::vector<ElementId> open(seeds.begin(), seeds.end());
    const std::vector<bool> given = model::mark_members(mesh_.element_count(), open);
    std::vector<bool> met(mesh_.element_count(), false);
    while (!open.empty()) {
      const ElementId e = open.back();
      open.pop_back();
      if (met[e.index()] || host_.property_part_index(e) != part_) {
        continue;
      }
      met[e.index()] = true;
      if (!given[e.index()] && !wanted(e)) {
        continue;
      }
      in_[e.index()] = true;
      for (int s = 0; s < base::element_info(mesh_.type[e.index()]).sides; ++s) {
        if (const auto other = host_.neighbour({e, s})) {
          open.push_back(*other);
        }
      }
    }
  }

  [[nodiscard]] std::vector<ElementId> taken() const {
    std::vector<ElementId> result;
    for (const ElementId e : host_.property_part_elements(part_)) {
      if (in_[e.index()]) {
        result.push_back(e);
      }
    }
    return result;
  }

  void find_outline() {
    outline_.clear();
    for (const model::Face& face :
         host_.sides_facing_outside(taken(), [&](ElementId e) { return in_[e.index()]; })) {
      outline_.push_back({face, !host_.neighbour(face)});
    }
    by_edge_.clear();
    by_node_.clear();
    for (std::size_t f = 0; f < outline_.size(); ++f) {
      const FaceNodes nodes = face_nodes(mesh_, outline_[f].face);
      for (std::size_t i = 0; i < nodes.corners; ++i) {
        const auto [a, b] = nodes.edge(i);
        by_edge_[std::minmax(a, b)].push_back(f);
        by_node_[a].push_back(f);
      }
    }
  }

  /// Takes in what lies round edges with more than two faces of the outline, and nodes with more
  /// than one sheet of it. False if there was nothing to take.
  bool take_pinched() {
    bool more = false;
    bad_ = false;
    for (const auto& [edge, faces] : by_edge_) {
      if (faces.size() == 2) {
        continue;
      }
      bad_ = true;
      for (const ElementId e : host_.elements_around(edge.first)) {
        const auto nodes = mesh_.element_nodes(e);
        if (std::find(nodes.begin(), nodes.end(), edge.second) != nodes.end()) {
          more = take(e) || more;
        }
      }
    }
    if (bad_) {
      return more;
    }
    for (const auto& [node, faces] : by_node_) {
      if (sheets(node, faces) == 1) {
        continue;
      }
      bad_ = true;
      for (const ElementId e : host_.elements_around(node)) {
        more = take(e) || more;
      }
    }
    return more;
  }

  bool take(ElementId e) {
    const bool fresh = !in_[e.index()] && host_.property_part_index(e) == part_;
    in_[e.index()] = in_[e.index()] || fresh;
    return fresh;
  }

  /// How many sheets of the outline meet at a node.
  std::size_t sheets(NodeId node, const std::vector<std::size_t>& faces) {
    base::DisjointSets sets(faces.size());
    std::map<NodeId, std::size_t> first;
    for (std::size_t k = 0; k < faces.size(); ++k) {
      const FaceNodes nodes = face_nodes(mesh_, outline_[faces[k]].face);
      for (std::size_t i = 0; i < nodes.corners; ++i) {
        const auto [a, b] = nodes.edge(i);
        if (a == node || b == node) {
          const auto [at, fresh] = first.try_emplace(a == node ? b : a, k);
          sets.join_sets(at->second, k);
        }
      }
    }
    std::set<std::size_t> roots;
    for (std::size_t k = 0; k < faces.size(); ++k) {
      roots.insert(sets.root(k));
    }
    return roots.size();
  }

  [[nodiscard]] std::vector<std::vector<CavityFace>> shells() const {
    base::DisjointSets sets(outline_.size());
    for (const auto& [edge, faces] : by_edge_) {
      sets.join_sets(faces[0], faces[1]);
    }
    std::map<std::size_t, std::vector<CavityFace>> by_root;
    for (std::size_t f = 0; f < outline_.size(); ++f) {
      by_root[sets.root(f)].push_back(outline_[f]);
    }
    std::vector<std::vector<CavityFace>> result;
    std::size_t outermost = 0;
    double widest = 0.0;
    for (auto& [root, faces] : by_root) {
      geometry::Box<3> box;
      for (const CavityFace& face : faces) {
        const FaceNodes nodes = face_nodes(mesh_, face.face);
        for (const NodeId n : nodes.corner_nodes()) {
          box.extend({mesh_.x[n.index()], mesh_.x[n.index()]});
        }
      }
      if (box.diagonal() > widest) {
        widest = box.diagonal();
        outermost = result.size();
      }
      result.push_back(std::move(faces));
    }
    std::swap(result.front(), result[outermost]);
    return result;
  }

  const SolidHostMesh& host_;
  const model::Mesh& mesh_;
  const CrackFrame& frame_;
  std::span<const CrackDistanceField> cracks_;
  std::vector<bool> in_;
  std::size_t part_ = 0;
  std::vector<CavityFace> outline_;
  std::map<EdgeKey, std::vector<std::size_t>> by_edge_;
  std::map<NodeId, std::vector<std::size_t>> by_node_;
  bool bad_ = false;
};

} // namespace

SolidCavity find_solid_cavity(const SolidHostMesh& host, const CrackFrame& frame,
                              std::span<const CrackDistanceField> cracks,
                              std::span<const ElementId> seeds) {
  return Digger(host, frame, cracks).build_cavities(seeds);
}

std::vector<SetCutByCavity> find_sets_cut_by_cavity(const SolidHostMesh& host,
                                                    const SolidCavity& cavity) {
  std::vector<SetCutByCavity> found;
  for (std::size_t s = 0; s < host.mesh().element_sets.size(); ++s) {
    const model::ElementSet& set = host.mesh().element_sets[s];
    const std::vector<bool> has = model::mark_members(host.mesh().element_count(), set.elements);
    const ElementId first = cavity.elements.front();
    const auto other = std::ranges::find_if(
        cavity.elements, [&](ElementId e) { return has[e.index()] != has[first.index()]; });
    if (other != cavity.elements.end()) {
      found.push_back(
          {s, set.name,
           0.5 * (host.bounding_ball(first).middle + host.bounding_ball(*other).middle)});
    }
  }
  return found;
}

SolidGrading solid_patch_grading(std::span<const PatchSolidCrack> cracks,
                                 const std::vector<std::vector<PatchTriangle>>& rims,
                                 const PatchMeshBuilder& net) {
  constexpr double growth_at_rim = 0.5; // beside small faces of the cavity
  SolidGrading size;
  for (const PatchSolidCrack& crack : cracks) {
    for (const Tube& tube : crack.tubes) {
      for (std::size_t i = 0; i < tube.stations.size(); ++i) {
        size.add_size_source({rounded(tube.stations[i].x),
                              rounded(tube.fill_size_beside_tube(i)) / crack.fill.finer,
                              crack.fill.growth_with_distance(), rounded(tube.radius[i])});
      }
    }
  }
  // Faces of a finer host.
  const SolidGrading own = size;
  for (const std::vector<PatchTriangle>& rim : rims) {
    for (const PatchTriangle& t : rim) {
      const Vec3 middle =
          (net.local_position(t[0]) + net.local_position(t[1]) + net.local_position(t[2])) / 3.0;
      const double edge = ((net.local_position(t[1]) - net.local_position(t[0])).norm() +
                           (net.local_position(t[2]) - net.local_position(t[1])).norm() +
                           (net.local_position(t[0]) - net.local_position(t[2])).norm()) /
                          3.0;
      if (edge < 0.7 * own(middle)) {
        size.add_size_source({middle, edge, growth_at_rim});
      }
    }
  }
  return size;
}

} // namespace spricka::mesh
