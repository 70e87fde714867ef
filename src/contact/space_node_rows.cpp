// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/space_node_rows.hpp"

#include "base/index.hpp"
#include "contact/row_builder.hpp"
#include "contact/space/frames.hpp"
#include "contact/space/opposite.hpp"
#include "geometry/box_tree.hpp"
#include "shape/quadrature.hpp"

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

constexpr double off_normal_in_space = 1e-3; // of the mean size of faces
constexpr int node_degree = 5;

// A node of a smooth part, with the sum of its faces' normals and its share of their area.
struct PartNodeArea {
  Vec3 x = Vec3::Zero();
  Vec3 normal = Vec3::Zero();
  double area = 0.0;
};
using PartNodes = std::map<std::pair<std::size_t, base::NodeId>, PartNodeArea>;

// Integrals of the shape functions of a face.
geometry::SideValues shape_areas(const geometry::ElementSide& face) {
  geometry::SideValues area = geometry::SideValues::Zero(index(face.nodes.size()));
  face.for_quadrature_points(node_degree, [&](const Vec2& r, double weight) {
    area += weight * face.area_vector(r).norm() * face.N(r);
  });
  return area;
}

// Integrals of the hats on its triangles.
geometry::SideValues hat_areas(const geometry::ElementSide& face) {
  geometry::SideValues area = geometry::SideValues::Zero(index(face.nodes.size()));
  for (const FaceTriangle& t : face_triangles(face)) {
    const std::array<Vec2, 3> r = corner_coordinates(face, t);
    const Vec2 a = r[1] - r[0];
    const Vec2 b = r[2] - r[0];
    const double r_area2 = a.x() * b.y() - a.y() * b.x();
    for (const auto& [q, weight] : shape::triangle_rule(node_degree)) {
      const double w = weight * r_area2 * face.area_vector(r[0] + q[0] * a + q[1] * b).norm();
      area[t[0]] += w * (1.0 - q[0] - q[1]);
      area[t[1]] += w * q[0];
      area[t[2]] += w * q[1];
    }
  }
  return area;
}

PartNodes nodes_by_part(const SpaceSurface& surface) {
  PartNodes all;
  for (std::size_t f = 0; f < surface.faces.size(); ++f) {
    const geometry::ElementSide& face = surface.faces[f];
    const geometry::SideValues area = face.nodes.size() == 6 ? hat_areas(face) : shape_areas(face);
    for (std::size_t i = 0; i < face.nodes.size(); ++i) {
      PartNodeArea& node = all[{surface.part[f], face.nodes[i]}];
      const geometry::SidePoint at = face.point(face.node_coordinates(static_cast<int>(i)));
      node.x = face.X.col(index(i));
      node.normal += surface_normal(surface, f, at);
      node.area += area[index(i)];
    }
  }
  return all;
}

bool has_faces_of_8(const SpaceSurface& surface) {
  return std::ranges::any_of(
      surface.faces, [](const geometry::ElementSide& face) { return face.nodes.size() == 8; });
}

// The target's nodes in a tree, to find the one before another node.
class Targets {
public:
  Targets(const SpaceSurface& surface, double reach, double across)
      : reach_(reach), across_(across) {
    std::vector<geometry::Box<3>> boxes;
    for (const auto& [key, node] : nodes_by_part(surface)) {
      nodes_.emplace_back(key.second, node);
      boxes.push_back({node.x, node.x});
    }
    tree_ = geometry::BoxTree<3>(boxes);
  }

  struct OppositeNode {
    base::NodeId node;
    double gap = 0.0;
  };
  [[nodiscard]] std::optional<OppositeNode> before(const Vec3& x, const Vec3& n) const {
    const std::array<Vec3, 2> ends{x + reach_ * n, x - reach_ * n};
    std::optional<OppositeNode> found;
    for (const std::size_t i : tree_.boxes_meeting(geometry::Box<3>::around(ends).grown(across_))) {
      const auto& [node, other] = nodes_[i];
      const Vec3 d = other.x - x;
      const double along = d.dot(n);
      if (other.normal.dot(n) < 0.0 && (d - along * n).norm() <= across_ &&
          std::abs(along) <= reach_ && (!found || std::abs(along) < std::abs(found->gap))) {
        found = OppositeNode{node, along};
      }
    }
    return found;
  }

private:
  double reach_, across_;
  std::vector<std::pair<base::NodeId, PartNodeArea>> nodes_;
  geometry::BoxTree<3> tree_;
};

} // namespace

void space_node_rows(PairConstraints& pair, std::optional<double> declared_gap, bool tangents) {
  const SpaceSurface& own = pair.contact.space;
  if (pair.rigid) {
    pair.trouble = "PAIRING=NODE is not for rigid targets of solids (use PAIRING=SEGMENT)";
    return;
  }
  if (has_faces_of_8(own) || has_faces_of_8(pair.target.space)) {
    pair.trouble = "PAIRING=NODE means nothing on faces of 8 nodes, where a uniform pressure pulls "
                   "at the corners (use PAIRING=SEGMENT, or elements HEXEC27)";
    return;
  }
  const Targets targets(pair.target.space, farthest_opposite * own.extent,
                        off_normal_in_space * own.mean_size);
  const SurfaceFrames frames(own);
  const PartNodes nodes = nodes_by_part(own);
  std::size_t lonely = 0;
  for (const auto& [key, node] : nodes) {
    const Vec3 n = node.normal.normalized();
    const auto other = targets.before(node.x, n);
    MultiplierFunction function{.node = key.second, .part = key.first, .held = {}};
    function.whole = node.area;
    if (!other) {
      ++lonely;
      pair.functions.push_back(function);
      continue;
    }
    pair.found = true;
    function.area = node.area;
    function.row = static_cast<int>(pair.normal.size());
    pair.functions.push_back(function);
    const std::array<Vec3, 3> along = frames.at(key.first, n);
    for (std::size_t k = 0; k < (tangents ? 3U : 1U); ++k) {
      ConstraintRowBuilder row;
      row.area = node.area;
      row.add_contribution(key.second, -node.area * along[k]);
      row.add_contribution(other->node, node.area * along[k]);
      if (k > 0) {
        pair.tangent.push_back(row.make_row(key.second, function.row));
        continue;
      }
      row.gap = node.area *
                declared_gap.value_or(zero_round_off(other->gap, node.x.cwiseAbs().maxCoeff()));
      row.round_gap = row.gap;
      pair.normal.push_back(row.make_row(key.second));
    }
  }
  if (pair.found && lonely > 0) {
    pair.trouble = fmt::format("PAIRING=NODE needs a master node opposite each slave node; {} of "
                               "{} slave nodes have none (use PAIRING=SEGMENT)",
                               lonely, nodes.size());
  }
}

} // namespace spricka::contact
