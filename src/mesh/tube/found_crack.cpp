// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/tube/found_crack.hpp"

#include "mesh/boundary.hpp"
#include "mesh/cut/coincidence.hpp"
#include "mesh/side_index.hpp"
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

/// Nodes within this part of the shortest edge at the front lie at one place.
constexpr double at_one_place = 1e-4;
/// Cosine of the angle at which faces of one crack go on from side to side: others that lie on one
/// another are those of a contact.
constexpr double least_cosine = 0.5;
/// Rings of elements that are taken for the surroundings of the front.
constexpr double rings_of_front = 3.0;

/// A side of the body with its corners by the places they lie at.
struct PlacedSide : FaceNodes {
  model::Face face;
  std::vector<std::size_t> places; ///< [corner]
  Vec3 normal = Vec3::Zero();      ///< outer, of the size of the side
};

/// What is found of a crack's faces.
struct PairedSides {
  std::vector<PlacedSide> sides;
  std::vector<std::size_t> twin; ///< [side] the one it lies on, or their number
  std::vector<std::size_t> upper;
  double shortest = 0.0; ///< edge at the front
};

/// Finds the fronts at which the faces of a crack end.
class ExistingFrontFinder {
public:
  ExistingFrontFinder(const ExistingCrack& crack, CrackedMesh& cracked, const PairedSides& found)
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
  const PairedSides& found_;
};

/// Finds the sides of the faces.
class CrackFaceFinder {
public:
  CrackFaceFinder(const ExistingCrack& crack, CrackedMesh& cracked)
      : crack_(crack), cracked_(cracked), mesh_(cracked.mesh) {}

  std::string find() {
    for (std::string (CrackFaceFinder::*step)() :
         {&CrackFaceFinder::place_sides, &CrackFaceFinder::pair_sides, &CrackFaceFinder::spread,
          &CrackFaceFinder::take_faces}) {
      if (std::string why = (this->*step)(); !why.empty()) {
        return why;
      }
    }
    return ExistingFrontFinder(crack_, cracked_, found_).find();
  }

private:
  [[nodiscard]] const Vec3& x(NodeId n) const { return mesh_.x[n.index()]; }
  [[nodiscard]] base::Label label(NodeId n) const { return mesh_.node_label[n.index()]; }

  // Sides on the surface, with numbers for the places of their nodes.
  std::string place_sides() {
    const std::set<NodeId> front(crack_.front.begin(), crack_.front.end());
    double shortest = std::numeric_limits<double>::infinity();
    std::set<NodeId> used;
    for (const model::Face& face : SideIndex(mesh_).unshared_sides()) {
      PlacedSide& side = found_.sides.emplace_back(PlacedSide{face_nodes(mesh_, face), face, {}});
      for (std::size_t k = 0; k < side.corners; ++k) {
        const auto [a, b] = side.edge(k);
        if (front.contains(a) || front.contains(b)) {
          shortest = std::min(shortest, (x(a) - x(b)).norm());
        }
      }
      const Vec3 across = x(side.all[side.corners - 1]) - x(side.all[1]);
      side.normal =
          0.5 *
          (side.corners == 3
               ? Vec3(x(side.all[1]) - x(side.all[0])).cross(Vec3(x(side.all[2]) - x(side.all[0])))
               : Vec3(x(side.all[2]) - x(side.all[0])).cross(across));
      used.insert(side.all.begin(), side.all.end());
    }
    if (!std::isfinite(shortest)) {
      return "no node of its FRONT is a corner of an element on the surface of the body or of a "
             "crack";
    }
    found_.shortest = shortest;
    number_places({used.begin(), used.end()});
    for (PlacedSide& side : found_.sides) {
      for (std::size_t k = 0; k < side.corners; ++k) {
        side.places.push_back(place_.at(side.all[k]));
      }
    }
    return {};
  }

  // Nodes nearer to one another than `at_one_place` get one number, in the order of their x.
  void number_places(std::vector<NodeId> nodes) {
    std::ranges::sort(nodes, [&](NodeId a, NodeId b) {
      return std::pair(x(a).x(), a.value) < std::pair(x(b).x(), b.value);
    });
    CoincidentPoints places(at_one_place * found_.shortest);
    for (const NodeId n : nodes) {
      place_.emplace(n, places.find_or_add_number(x(n)));
    }
  }

  // Two sides at the same places, one of each body, are faces of a crack.
  std::string pair_sides() {
    std::map<std::vector<std::size_t>, std::vector<std::size_t>> at;
    for (std::size_t s = 0; s < found_.sides.size(); ++s) {
      std::vector<std::size_t> key = found_.sides[s].places;
      std::ranges::sort(key);
      at[std::move(key)].push_back(s);
    }
    found_.twin.assign(found_.sides.size(), found_.sides.size());
    for (const auto& [key, found] : at) {
      const auto net = [&](std::size_t s) {
        return mesh_.element_net[found_.sides[s].face.element.index()];
      };
      if (found.size() == 2 && net(found[0]) == net(found[1])) {
        found_.twin[found[0]] = found[1];
        found_.twin[found[1]] = found[0];
      }
    }
    return {};
  }

  // From sides that end at the front over common edges, each time to the one whose normal goes on.
  std::string spread() {
    const std::set<NodeId> front(crack_.front.begin(), crack_.front.end());
    std::map<std::size_t, std::vector<std::size_t>> at_place;
    for (std::size_t s = 0; s < found_.sides.size(); ++s) {
      for (const std::size_t place : found_.sides[s].places) {
        if (found_.twin[s] < found_.sides.size()) {
          at_place[place].push_back(s);
        }
      }
    }
    std::vector<bool> seen(found_.sides.size(), false);
    for (std::size_t s = 0; s < found_.sides.size(); ++s) {
      const bool begins = found_.twin[s] < found_.sides.size() &&
                          std::any_of(found_.sides[s].all.begin(),
                                      found_.sides[s].all.begin() +
                                          static_cast<std::ptrdiff_t>(found_.sides[s].corners),
                                      [&](NodeId n) { return front.contains(n); });
      if (begins && !seen[s] && !seen[found_.twin[s]]) {
        grow(s, at_place, seen);
      }
    }
    if (found_.upper.empty()) {
      return "no faces begin at its FRONT: of a crack that is in the mesh already each face has "
             "its own nodes, at the same places, and those of the front are common to both";
    }
    return {};
  }

  void grow(std::size_t first, const std::map<std::size_t, std::vector<std::size_t>>& at_place,
            std::vector<bool>& seen) {
    std::vector<std::size_t> open{upward(first) ? found_.twin[first] : first};
    seen[first] = seen[found_.twin[first]] = true;
    while (!open.empty()) {
      const std::size_t s = open.back();
      open.pop_back();
      found_.upper.push_back(s);
      const std::set<std::size_t> own(found_.sides[s].places.begin(), found_.sides[s].places.end());
      for (const std::size_t place : own) {
        for (const std::size_t next : at_place.at(place)) {
          const auto common = std::ranges::count_if(found_.sides[next].places,
                                                    [&](auto p) { return own.contains(p); });
          const double turn =
              found_.sides[next].normal.normalized().dot(found_.sides[s].normal.normalized());
          if (common >= 2 && !seen[next] && std::abs(turn) > least_cosine) {
            seen[next] = seen[found_.twin[next]] = true;
            open.push_back(turn > 0.0 ? next : found_.twin[next]);
          }
        }
      }
    }
  }

  // The outer normal of an upper face points down.
  [[nodiscard]] bool upward(std::size_t s) const {
    Eigen::Index largest = 0;
    found_.sides[s].normal.cwiseAbs().maxCoeff(&largest);
    return found_.sides[s].normal[largest] > 0.0;
  }

  std::string take_faces() {
    std::ranges::sort(found_.upper);
    CrackFaceNodes& faces = cracked_.faces[crack_.crack.index()];
    std::map<NodeId, NodeId> pairs;
    for (const std::size_t s : found_.upper) {
      const PlacedSide& own = found_.sides[s];
      const PlacedSide& other = found_.sides[found_.twin[s]];
      faces.left_sides.push_back(own.face);
      faces.right_sides.push_back(other.face);
      for (const NodeId n : own.all) {
        const auto twin =
            std::ranges::find_if(other.all, [&](NodeId m) { return place_.at(m) == place_.at(n); });
        if (twin == other.all.end()) {
          return fmt::format("the faces at node {} have mid nodes at different places", label(n));
        }
        pairs.emplace(n, *twin);
      }
    }
    for (const auto& [left, right] : pairs) {
      faces.left.push_back(left);
      faces.right.push_back(right);
    }
    return {};
  }

  const ExistingCrack& crack_;
  CrackedMesh& cracked_;
  const model::Mesh& mesh_;
  PairedSides found_;
  std::map<NodeId, std::size_t> place_;
};

} // namespace

std::string find_existing_crack(const ExistingCrack& crack, CrackedMesh& cracked) {
  return CrackFaceFinder(crack, cracked).find();
}

} // namespace spricka::mesh
