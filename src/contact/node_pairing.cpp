// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/node_pairing.hpp"

#include "base/index.hpp"
#include "contact/node_pair.hpp"
#include "contact/rigid_target.hpp"
#include "contact/space/frames.hpp"
#include "contact/space/opposite.hpp"
#include "geometry/box_tree.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include <fmt/format.h>

namespace spricka::contact {

using base::index;

namespace {

constexpr double off_normal = 1e-3; // of the mean size of facets
// About an axis the corner of a quadratic edge that lies on the axis has no area: no force acts
// there, and its row would say nothing. Share of the square of the mean edge length.
constexpr double no_node_area = 1e-9;
// Exact on straight edges, about an axis as well.
constexpr int node_degree = 5;

// A node of a smooth part, with the sum of its facets' normals and its share of their area.
struct SurfaceNode {
  SmoothPartNode key;
  Vec3 x = Vec3::Zero();
  Vec3 normal = Vec3::Zero();
  double area = 0.0;
};

// Integrals of the shape functions of a facet: what a uniform pressure puts on its nodes.
geometry::SideValues shape_areas(const geometry::ElementSide& facet, const PairConstraints& pair) {
  geometry::SideValues area = geometry::SideValues::Zero(index(facet.nodes.size()));
  facet.for_quadrature_points(node_degree, [&](const Vec2& r, double weight) {
    const geometry::SidePoint at = facet.point(r);
    area += weight * at.area_vector().norm() *
            out_of_plane_depth(pair.contact, pair.target, at.x.head<2>()) * facet.N(r);
  });
  return area;
}

// Integrals of the hats on the triangles of a face.
geometry::SideValues hat_areas(const geometry::ElementSide& face) {
  geometry::SideValues area = geometry::SideValues::Zero(index(face.nodes.size()));
  for (const HatNodes& t : hat_elements(face)) {
    visit_hat_quadrature_points(face, t, node_degree,
                                [&](const Vec3& hat, const Vec2& r, double weight) {
                                  const Vec3 areas = weight * face.area_vector(r).norm() * hat;
                                  for (std::size_t i = 0; i < t.size(); ++i) {
                                    area[t[i]] += areas[index(i)];
                                  }
                                });
  }
  return area;
}

// In the order of smooth_part_nodes(), so that rows run along a curve.
std::vector<SurfaceNode> collect_nodes(const ContactSurface& surface, const PairConstraints& pair) {
  std::vector<SurfaceNode> all;
  std::map<SmoothPartNode, std::size_t> place;
  for (const SmoothPartNode& key : smooth_part_nodes(surface)) {
    place[key] = all.size();
    all.push_back({.key = key});
  }
  for (std::size_t f = 0; f < surface.facets.size(); ++f) {
    const geometry::ElementSide& facet = surface.facets[f];
    const geometry::SideValues area =
        facet.nodes.size() == 6 ? hat_areas(facet) : shape_areas(facet, pair);
    for (std::size_t i = 0; i < facet.nodes.size(); ++i) {
      SurfaceNode& node = all[place.at({surface.part[f], facet.nodes[i]})];
      const geometry::SidePoint at = facet.point(facet.node_local_coordinates(static_cast<int>(i)));
      node.x = facet.X.col(index(i));
      node.normal += surface_normal(surface, f, at);
      node.area += area[index(i)];
    }
  }
  return all;
}

// What a node has opposite: a node, or a point of a rigid target.
struct OppositePoint {
  base::NodeId node; ///< invalid on a rigid target
  Vec3 normal = Vec3::Zero();
  double gap = 0.0;
};

std::optional<OppositePoint> rigid_opposite(const SurfaceNode& node, const PairConstraints& pair) {
  const std::optional<RigidProjection> foot = normal_projection(*pair.rigid, node.x.head<2>());
  if (!foot || foot->beyond || node.normal.head<2>().dot(foot->normal) <= 0.0 ||
      std::abs(foot->gap) > farthest_opposite * pair.contact.extent) {
    return std::nullopt;
  }
  return OppositePoint{base::NodeId(), base::embed_in_space(foot->normal), foot->gap};
}

// The target's nodes in a tree, to find the one before another node.
class TargetNodes {
public:
  explicit TargetNodes(const PairConstraints& pair)
      : reach_(farthest_opposite * pair.contact.extent),
        across_(off_normal * pair.contact.mean_size), nodes_(collect_nodes(pair.target, pair)) {
    std::vector<geometry::Box<3>> boxes;
    for (const SurfaceNode& node : nodes_) {
      boxes.push_back({node.x, node.x});
    }
    tree_ = geometry::BoxTree<3>(boxes);
  }

  [[nodiscard]] std::optional<OppositePoint> opposite(const SurfaceNode& node) const {
    const Vec3 n = node.normal.normalized();
    const std::array<Vec3, 2> ends{node.x + reach_ * n, node.x - reach_ * n};
    std::optional<OppositePoint> found;
    for (const std::size_t i :
         tree_.boxes_intersecting(geometry::Box<3>::around(ends).grown(across_))) {
      const SurfaceNode& other = nodes_[i];
      const Vec3 d = other.x - node.x;
      const double along = d.dot(n);
      if (other.normal.dot(n) < 0.0 && (d - along * n).norm() <= across_ &&
          std::abs(along) <= reach_ && (!found || std::abs(along) < std::abs(found->gap))) {
        found = OppositePoint{other.key.second, n, along};
      }
    }
    return found;
  }

private:
  double reach_, across_;
  std::vector<SurfaceNode> nodes_;
  geometry::BoxTree<3> tree_;
};

bool has_faces_of_8(const ContactSurface& surface) {
  return std::ranges::any_of(
      surface.facets, [](const geometry::ElementSide& face) { return face.nodes.size() == 8; });
}

// Why node pairs mean nothing in space, if they do not.
std::string refusal(const PairConstraints& pair) {
  if (pair.rigid_shape) {
    return "PAIRING=NODE is not for rigid targets of solids (use PAIRING=SEGMENT)";
  }
  if (has_faces_of_8(pair.contact) || has_faces_of_8(pair.target)) {
    return "PAIRING=NODE means nothing on faces of 8 nodes, where a uniform pressure pulls at the "
           "corners (use PAIRING=SEGMENT, or elements HEXEC27)";
  }
  return {};
}

} // namespace

void fill_node_pair_rows(PairConstraints& pair, std::optional<double> declared_gap, bool tangents) {
  pair.trouble = refusal(pair);
  if (!pair.trouble.empty()) {
    return;
  }
  const std::vector<SurfaceNode> nodes = collect_nodes(pair.contact, pair);
  const TargetNodes targets(pair);
  const SurfaceFrames frames(pair.contact);
  const std::size_t directions = tangents ? frames.count() : 1;
  std::size_t lonely = 0;
  for (const SurfaceNode& node : nodes) {
    const std::optional<OppositePoint> other =
        pair.rigid ? rigid_opposite(node, pair) : targets.opposite(node);
    MultiplierFunction& function = pair.functions.emplace_back();
    function.node = node.key.second;
    function.part = node.key.first;
    function.whole = node.area;
    if (!other) {
      lonely += pair.rigid ? 0 : 1; // beyond a rigid target there is nothing
      continue;
    }
    pair.found = true;
    if (pair.contact.axial &&
        node.area <= no_node_area * pair.contact.mean_size * pair.contact.mean_size) {
      continue;
    }
    function.area = node.area;
    function.row = static_cast<int>(pair.normal.size());
    NodePair both{.node = node.key.second,
                  .other = other->node,
                  .push = {},
                  .area = node.area,
                  .gap = declared_gap.value_or(
                      zero_gap_below_round_off(other->gap, node.x.cwiseAbs().maxCoeff()))};
    const std::array<Vec3, 3> along = frames.at(node.key.first, other->normal);
    for (std::size_t k = 0; k < directions; ++k) {
      both.push.emplace_back(node.area * along[k]);
    }
    append_node_rows(both, pair);
  }
  if (pair.found && lonely > 0) {
    pair.trouble = fmt::format("PAIRING=NODE needs a master node opposite each slave node; {} of "
                               "{} slave nodes have none (use PAIRING=SEGMENT)",
                               lonely, nodes.size());
  }
}

} // namespace spricka::contact
