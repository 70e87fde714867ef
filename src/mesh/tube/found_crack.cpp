// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/tube/found_crack.hpp"

#include "mesh/cut/existing_crack.hpp"
#include "mesh/tube/solid_crack.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <set>
#include <utility>

#include <Eigen/Geometry>
#include <fmt/format.h>

namespace spricka::mesh {

namespace {

using base::NodeId;
using base::Vec3;

/// Rings of elements that are taken for the surroundings of the front.
constexpr double rings_of_front = 3.0;

/// Finds the fronts at which the faces of a crack end.
class ExistingFrontFinder {
public:
  ExistingFrontFinder(const ExistingCrack& crack, CrackedMesh& cracked,
                      const ExistingCrackSides& found)
      : crack_(crack), cracked_(cracked), mesh_(cracked.mesh), found_(found) {}

  // Edges between nodes of the front that end the crack, in the order of t = m x b.
  std::string find() {
    const std::set<NodeId> given(crack_.front.begin(), crack_.front.end());
    std::map<NodeId, NodeId> next;
    std::map<NodeId, Vec3> up;
    std::map<std::pair<NodeId, NodeId>, NodeId> middle;
    for (const std::size_t s : found_.upper) {
      const PlacedSide& side = found_.sides[s];
      for (std::size_t k = 0; k < side.corners; ++k) {
        const auto [a, b] = side.edge(k);
        if (!single(a, s) || !single(b, s) || !given.contains(a) || !given.contains(b)) {
          continue;
        }
        // Seen along the outer normal of the upper face, -b, the side lies on the left of its
        // edges: t = m x b runs the same way.
        if (!next.emplace(a, b).second) {
          return fmt::format("its front branches at node {}", label(a));
        }
        up.try_emplace(a, Vec3::Zero()).first->second -= side.normal;
        up.try_emplace(b, Vec3::Zero()).first->second -= side.normal;
        if (side.mid_node(k).valid()) {
          middle.emplace(std::pair(a, b), side.mid_node(k));
        }
      }
    }
    if (next.empty()) {
      return "no two nodes of its FRONT are joined by an edge at which its faces end";
    }
    int number = 0;
    while (!next.empty()) {
      add_front(line_of(next), up, middle, ++number);
    }
    return {};
  }

private:
  [[nodiscard]] const Vec3& x(NodeId n) const { return mesh_.x[n.index()]; }
  [[nodiscard]] base::Label label(NodeId n) const { return mesh_.node_label[n.index()]; }

  // A node that both faces have.
  [[nodiscard]] bool single(NodeId n, std::size_t upper) const {
    return std::ranges::find(found_.sides[found_.twin[upper]].all, n) !=
           found_.sides[found_.twin[upper]].all.end();
  }

  // Takes one line out of the edges; a closed one begins with its lowest node, which ends it, too.
  static std::vector<NodeId> line_of(std::map<NodeId, NodeId>& next) {
    std::set<NodeId> ends;
    for (const auto& [from, to] : next) {
      ends.insert(to);
    }
    NodeId at = next.begin()->first;
    for (const auto& [from, to] : next) {
      if (!ends.contains(from)) {
        at = from;
        break;
      }
    }
    std::vector<NodeId> line{at};
    for (auto found = next.find(at); found != next.end(); found = next.find(line.back())) {
      line.push_back(found->second);
      next.erase(found);
    }
    return line;
  }

  void add_front(std::vector<NodeId> line, const std::map<NodeId, Vec3>& up,
                 const std::map<std::pair<NodeId, NodeId>, NodeId>& middle, int number) {
    const bool closed = line.size() > 3 && line.front() == line.back();
    std::vector<Vec3> points;
    std::vector<Vec3> normals;
    for (std::size_t k = 0; k < line.size() && !(closed && k + 1 == line.size()); ++k) {
      points.push_back(x(line[k]));
      normals.push_back(up.at(line[k]).normalized());
      const bool last = k + 1 == line.size();
      const auto between = last ? middle.end() : middle.find({line[k], line[k + 1]});
      if (between != middle.end()) {
        points.push_back(x(between->second));
        normals.push_back(
            (up.at(line[k]).normalized() + up.at(line[k + 1]).normalized()).normalized());
      }
    }
    if (closed) {
      line.pop_back();
    }
    CrackFront front;
    front.crack = crack_.crack;
    front.number = number;
    front.curve = std::make_shared<const FrontCurve>(std::move(points), std::move(normals), closed);
    front.points.clear();
    for (std::size_t k = 0; k < line.size(); ++k) {
      FrontPoint& point = front.points.emplace_back();
      point.node = line[k];
      point.at_surface = !closed && (k == 0 || k + 1 == line.size());
      point.size = size_at(line[k], {line.begin(), line.end()});
      point.radius = rings_of_front * point.size;
    }
    recompute_front_point_geometry(mesh_, front);
    front.size = std::ranges::min(front.points, {}, &FrontPoint::size).size;
    front.radius = rings_of_front * front.size;
    front.kind = closed ? CrackConfiguration::embedded : CrackConfiguration::surface;
    front.a = std::sqrt(area() / std::numbers::pi);
    cracked_.notes.push_back(
        fmt::format("crack {}: in the mesh already, as large as a circle of radius {:.4g}, {} "
                    "sides of elements "
                    "on each face, front of length {:.6g} with {} points, elements of {:.3g} at it",
                    crack_.name, front.a, found_.upper.size(), front.curve->length(),
                    front.points.size(), front.size));
    cracked_.fronts.push_back(std::move(front));
  }

  // The shortest edge of the crack's faces from a node of the front away from it.
  [[nodiscard]] double size_at(NodeId n, const std::set<NodeId>& front) const {
    double shortest = std::numeric_limits<double>::infinity();
    for (const std::size_t s : found_.upper) {
      const PlacedSide& side = found_.sides[s];
      for (std::size_t k = 0; k < side.corners; ++k) {
        const auto [a, b] = side.edge(k);
        if ((a == n && !front.contains(b)) || (b == n && !front.contains(a))) {
          shortest = std::min(shortest, (x(a) - x(b)).norm());
        }
      }
    }
    return std::isfinite(shortest) ? shortest : found_.shortest;
  }

  [[nodiscard]] double area() const {
    double sum = 0.0;
    for (const std::size_t s : found_.upper) {
      sum += found_.sides[s].normal.norm();
    }
    return sum;
  }

  const ExistingCrack& crack_;
  CrackedMesh& cracked_;
  const model::Mesh& mesh_;
  const ExistingCrackSides& found_;
};

// Upper and lower sides and the nodes of both faces.
std::string take_faces(const model::Mesh& mesh, const ExistingCrackSides& found,
                       CrackFaceNodes& faces) {
  std::map<NodeId, NodeId> pairs;
  for (const std::size_t s : found.upper) {
    faces.left_sides.push_back(found.sides[s].face);
    faces.right_sides.push_back(found.sides[found.twin[s]].face);
    for (const NodeId n : found.sides[s].all) {
      const NodeId opposite = found.opposite_node(s, n);
      if (!opposite.valid()) {
        return fmt::format("the faces at node {} have mid nodes at different places",
                           mesh.node_label[n.index()]);
      }
      pairs.emplace(n, opposite);
    }
  }
  for (const auto& [left, right] : pairs) {
    faces.left.push_back(left);
    faces.right.push_back(right);
  }
  return {};
}

} // namespace

std::string find_existing_crack(const ExistingCrack& crack, CrackedMesh& cracked) {
  ExistingCrackSides found;
  if (std::string why = find_existing_crack_sides(cracked.mesh, crack.front, found); !why.empty()) {
    return why;
  }
  if (std::string why = take_faces(cracked.mesh, found, cracked.faces[crack.crack.index()]);
      !why.empty()) {
    return why;
  }
  return ExistingFrontFinder(crack, cracked, found).find();
}

} // namespace spricka::mesh
