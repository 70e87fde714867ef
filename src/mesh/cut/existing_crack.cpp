// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/cut/existing_crack.hpp"

#include "mesh/cut/coincidence.hpp"
#include "mesh/side_index.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <span>
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

std::span<const std::size_t> corner_places(const PlacedSide& side) {
  return std::span(side.places).first(side.corners);
}

/// Outer, of the size of the side.
Vec3 side_normal(const model::Mesh& mesh, const PlacedSide& side) {
  const auto edge = [&](std::size_t from, std::size_t to) {
    return Vec3(mesh.x[side.all[to].index()] - mesh.x[side.all[from].index()]);
  };
  if (side.corners == 2) { // the body is on the left of an edge
    return {edge(0, 1).y(), -edge(0, 1).x(), 0.0};
  }
  return side.corners == 3 ? Vec3(0.5 * edge(0, 1).cross(edge(0, 2)))
                           : Vec3(0.5 * edge(0, 2).cross(edge(1, 3)));
}

/// Finds the sides of a crack's faces.
class CrackFaceFinder {
public:
  CrackFaceFinder(const model::Mesh& mesh, const std::vector<NodeId>& front,
                  ExistingCrackSides& found)
      : mesh_(mesh), front_(front.begin(), front.end()), found_(found) {}

  std::string find() {
    for (std::string (CrackFaceFinder::*step)() :
         {&CrackFaceFinder::place_sides, &CrackFaceFinder::pair_sides, &CrackFaceFinder::spread}) {
      if (std::string why = (this->*step)(); !why.empty()) {
        return why;
      }
    }
    std::ranges::sort(found_.upper);
    return {};
  }

private:
  [[nodiscard]] const Vec3& x(NodeId n) const { return mesh_.x[n.index()]; }
  [[nodiscard]] bool is_paired(std::size_t side) const {
    return found_.twin[side] < found_.sides.size();
  }

  // Sides on the surface, with numbers for the places of their nodes.
  std::string place_sides() {
    double shortest = std::numeric_limits<double>::infinity();
    std::set<NodeId> used;
    for (const model::Face& face : SideIndex(mesh_).unshared_sides()) {
      PlacedSide& side = found_.sides.emplace_back(PlacedSide{face_nodes(mesh_, face), face, {}});
      for (std::size_t k = 0; k < side.corners; ++k) {
        const auto [a, b] = side.edge(k);
        if (front_.contains(a) || front_.contains(b)) {
          shortest = std::min(shortest, (x(a) - x(b)).norm());
        }
      }
      side.normal = side_normal(mesh_, side);
      used.insert(side.all.begin(), side.all.end());
    }
    if (!std::isfinite(shortest)) {
      return "no node of its FRONT is a corner of an element on the surface of the body or of a "
             "crack";
    }
    found_.shortest = shortest;
    number_places({used.begin(), used.end()});
    return {};
  }

  // Nodes nearer to one another than `at_one_place` get one number, in the order of their x.
  void number_places(std::vector<NodeId> nodes) {
    std::ranges::sort(nodes, [&](NodeId a, NodeId b) {
      return std::pair(x(a).x(), a.value) < std::pair(x(b).x(), b.value);
    });
    CoincidentPoints places(at_one_place * found_.shortest);
    std::map<NodeId, std::size_t> number;
    for (const NodeId n : nodes) {
      number.emplace(n, places.find_or_add_number(x(n)));
    }
    for (PlacedSide& side : found_.sides) {
      for (const NodeId n : side.all) {
        side.places.push_back(number.at(n));
      }
    }
  }

  // Two sides at the same places, one of each body, are faces of a crack.
  std::string pair_sides() {
    std::map<std::vector<std::size_t>, std::vector<std::size_t>> at;
    for (std::size_t s = 0; s < found_.sides.size(); ++s) {
      const std::span<const std::size_t> corners = corner_places(found_.sides[s]);
      std::vector<std::size_t> key(corners.begin(), corners.end());
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

  // From sides that end at the front over what joins them, each time to the one whose normal goes
  // on.
  std::string spread() {
    std::map<std::size_t, std::vector<std::size_t>> at_place;
    for (std::size_t s = 0; s < found_.sides.size(); ++s) {
      for (const std::size_t place : corner_places(found_.sides[s])) {
        if (is_paired(s)) {
          at_place[place].push_back(s);
        }
      }
    }
    std::vector<bool> seen(found_.sides.size(), false);
    for (std::size_t s = 0; s < found_.sides.size(); ++s) {
      const bool begins =
          is_paired(s) && std::ranges::any_of(found_.sides[s].corner_nodes(),
                                              [&](NodeId n) { return front_.contains(n); });
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
    // Of an edge in space, or of a point in the plane.
    const int shared_corners = mesh_.dim - 1;
    std::vector<std::size_t> open{upward(first) ? found_.twin[first] : first};
    seen[first] = seen[found_.twin[first]] = true;
    while (!open.empty()) {
      const std::size_t s = open.back();
      open.pop_back();
      found_.upper.push_back(s);
      const std::span<const std::size_t> corners = corner_places(found_.sides[s]);
      const std::set<std::size_t> own(corners.begin(), corners.end());
      for (const std::size_t place : own) {
        for (const std::size_t next : at_place.at(place)) {
          const auto common = std::ranges::count_if(corner_places(found_.sides[next]),
                                                    [&](auto p) { return own.contains(p); });
          const double turn =
              found_.sides[next].normal.normalized().dot(found_.sides[s].normal.normalized());
          if (common >= shared_corners && !seen[next] && std::abs(turn) > least_cosine) {
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

  const model::Mesh& mesh_;
  std::set<NodeId> front_;
  ExistingCrackSides& found_;
};

/// Follows the faces of a crack in the plane from its tip back to its mouth, or to its other tip.
class CrackPathWalk {
public:
  CrackPathWalk(const model::Mesh& mesh, const ExistingCrackSides& found)
      : mesh_(mesh), found_(found) {
    for (const std::size_t upper : found.upper) {
      for (const std::size_t s : {upper, found.twin[upper]}) {
        by_end_.emplace(found.sides[s].all[1], s);
      }
    }
  }

  /// The side of the left face, which runs to the tip, and no other does; none: no tip.
  [[nodiscard]] bool is_tip(NodeId node) const {
    const auto [from, to] = by_end_.equal_range(node);
    return from != to && std::next(from) == to && found_.opposite_node(from->second, node) == node;
  }

  std::string walk_back(NodeId tip, CrackFaceNodes& faces) const {
    faces.left.push_back(tip);
    faces.right.push_back(tip);
    for (NodeId at = tip; at == tip || faces.right.back() != at;) {
      const auto [from, to] = by_end_.equal_range(at);
      if (from == to) {
        break; // the mouth
      }
      if (std::next(from) != to) {
        return fmt::format("its faces branch at node {}", mesh_.node_label[at.index()]);
      }
      const FaceNodes& side = found_.sides[from->second];
      for (const NodeId n : {side.mid_node(0), side.all[0]}) {
        if (!n.valid()) {
          continue;
        }
        faces.left.push_back(n);
        faces.right.push_back(found_.opposite_node(from->second, n));
        if (!faces.right.back().valid()) {
          return fmt::format("the faces at node {} have mid nodes at different places",
                             mesh_.node_label[n.index()]);
        }
      }
      at = side.all[0];
    }
    std::ranges::reverse(faces.left);
    std::ranges::reverse(faces.right);
    return {};
  }

private:
  const model::Mesh& mesh_;
  const ExistingCrackSides& found_;
  std::multimap<NodeId, std::size_t> by_end_; ///< sides of both faces by the node they run to
};

} // namespace

base::NodeId ExistingCrackSides::opposite_node(std::size_t s, base::NodeId node) const {
  const PlacedSide& own = sides[s];
  const PlacedSide& other = sides[twin[s]];
  const auto at = std::ranges::find(own.all, node) - own.all.begin();
  const auto there = std::ranges::find(other.places, own.places[static_cast<std::size_t>(at)]);
  return there == other.places.end()
             ? base::NodeId()
             : other.all[static_cast<std::size_t>(there - other.places.begin())];
}

std::string find_existing_crack_sides(const model::Mesh& mesh,
                                      const std::vector<base::NodeId>& front,
                                      ExistingCrackSides& found) {
  return CrackFaceFinder(mesh, front, found).find();
}

std::string find_existing_crack_path(const model::Mesh& mesh, const std::vector<base::NodeId>& tips,
                                     CrackFaceNodes& faces) {
  ExistingCrackSides found;
  if (std::string why = find_existing_crack_sides(mesh, tips, found); !why.empty()) {
    return why;
  }
  const CrackPathWalk walk(mesh, found);
  std::vector<NodeId> ends;
  std::ranges::copy_if(tips, std::back_inserter(ends),
                       [&](NodeId node) { return walk.is_tip(node); });
  if (ends.empty()) {
    return "no node of its FRONT is a tip, which is common to both faces and ends one crack";
  }
  const NodeId last = *std::ranges::max_element(
      ends, {}, [&](NodeId node) { return mesh.node_label[node.index()]; });
  if (std::string why = walk.walk_back(last, faces); !why.empty()) {
    return why;
  }
  for (const NodeId end : ends) {
    if (end != last && end != faces.left.front()) {
      return fmt::format("its FRONT has the tips of two cracks, nodes {} and {}: each has a card",
                         mesh.node_label[end.index()], mesh.node_label[last.index()]);
    }
  }
  return {};
}

} // namespace spricka::mesh
