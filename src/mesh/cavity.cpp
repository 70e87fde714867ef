// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/cavity.hpp"

#include "mesh/boundary.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

namespace spricka::mesh {
namespace {

using base::ElementId;
using base::NodeId;
using base::Vec2;

/// How near to the crack, in crack lengths, and to its tip, in rosette radii, the host's elements
/// are replaced: so near that triangles between would come out flat.
constexpr double reach_of_line = 0.2;
constexpr double reach_of_tip = 1.6;
/// The first part of a crack, where it may be near the boundary that it starts from.
constexpr double at_mouth = 0.05;

class Finder {
public:
  Finder(const Host& host, const Placement& placement)
      : host_(host), mesh_(host.mesh()), place_(placement), seed_(placement.mouth.face.element),
        in_(mesh_.element_count(), false) {}

  Cavity find() {
    flood();
    add_layer();
    while (add_pinched()) {
    }
    Cavity cavity;
    for (std::size_t e = 0; e < in_.size(); ++e) {
      if (in_[e]) {
        cavity.elements.emplace_back(e);
      }
    }
    for (const Chain& chain : chains(mesh_, outline())) {
      std::vector<OutlineEdge> loop;
      for (const model::Face& face : chain.faces) {
        loop.push_back({face, edge_of(mesh_, face), !host_.beyond(face).has_value()});
      }
      cavity.loops.push_back(std::move(loop));
    }
    return cavity;
  }

private:
  [[nodiscard]] bool allowed(ElementId e) const {
    return mesh_.element_net[e.index()] == mesh_.element_net[seed_.index()] &&
           mesh_.property[e.index()] == mesh_.property[seed_.index()];
  }
  [[nodiscard]] bool near(ElementId e) const {
    const std::vector<Vec2> shape = polygon(mesh_, e, place_.frame);
    return distance(shape, place_.line) < reach_of_line + same ||
           distance(shape, {place_.tip(), place_.tip()}) < reach_of_tip * place_.radius + same;
  }

  void flood() {
    std::vector<ElementId> front{seed_};
    if (place_.mouth.node.valid()) {
      for (const ElementId e : host_.around(place_.mouth.node)) {
        if (allowed(e)) {
          front.push_back(e);
        }
      }
    }
    for (const ElementId e : front) {
      in_[e.index()] = true;
    }
    while (!front.empty()) {
      const ElementId e = front.back();
      front.pop_back();
      for (int s = 0; s < base::info(mesh_.type[e.index()]).sides; ++s) {
        const auto next = host_.beyond({e, s});
        if (next && !in_[next->index()] && allowed(*next) && near(*next)) {
          in_[next->index()] = true;
          front.push_back(*next);
        }
      }
    }
  }

  void add_layer() {
    const std::vector<bool> core = in_;
    for (std::size_t e = 0; e < core.size(); ++e) {
      if (core[e]) {
        for (const NodeId n : mesh_.nodes_of(ElementId(e))) {
          add_around(n);
        }
      }
    }
  }

  bool add_around(NodeId n) {
    bool more = false;
    for (const ElementId e : host_.around(n)) {
      if (!in_[e.index()] && allowed(e)) {
        in_[e.index()] = true;
        more = true;
      }
    }
    return more;
  }

  [[nodiscard]] std::vector<model::Face> outline() const {
    std::vector<model::Face> result;
    for (std::size_t e = 0; e < in_.size(); ++e) {
      for (int s = 0; in_[e] && s < base::info(mesh_.type[e]).sides; ++s) {
        const model::Face face{ElementId(e), s};
        const auto other = host_.beyond(face);
        if (!other || !in_[other->index()]) {
          result.push_back(face);
        }
      }
    }
    return result;
  }

  /// A loop that meets itself at a node could not be meshed: takes in what lies round such nodes.
  bool add_pinched() {
    std::map<NodeId, int> leaving;
    for (const model::Face& face : outline()) {
      ++leaving[edge_of(mesh_, face).a];
    }
    bool more = false;
    for (const auto& [node, count] : leaving) {
      if (count > 1) {
        more = add_around(node) || more;
      }
    }
    return more;
  }

  const Host& host_;
  const model::Mesh& mesh_;
  const Placement& place_;
  ElementId seed_;
  std::vector<bool> in_;
};

/// The crack without its first part.
std::vector<Vec2> without_mouth(const std::vector<Vec2>& line) {
  std::vector<Vec2> result = line;
  const double first = (line[1] - line[0]).norm();
  result[0] = line[0] + std::min(0.5, at_mouth / first) * (line[1] - line[0]);
  return result;
}

bool leaves_body(const Host& host, const Placement& placement, const Cavity& cavity) {
  const bool covered =
      std::any_of(cavity.elements.begin(), cavity.elements.end(), [&](ElementId e) {
        return inside(placement.tip(), polygon(host.mesh(), e, placement.frame));
      });
  if (!covered) {
    return true;
  }
  const std::vector<Vec2> line = without_mouth(placement.line);
  for (const std::vector<OutlineEdge>& loop : cavity.loops) {
    for (const OutlineEdge& edge : loop) {
      std::array<Vec2, 3> p;
      for (std::size_t i = 0; i < 3; ++i) {
        p[i] =
            placement.frame.local(point_on(host.mesh(), edge.edge, static_cast<double>(i) - 1.0));
      }
      for (std::size_t k = 0; edge.free && k + 1 < line.size(); ++k) {
        if (distance(p[0], p[1], line[k], line[k + 1]) < 0.04 * at_mouth ||
            distance(p[1], p[2], line[k], line[k + 1]) < 0.04 * at_mouth) {
          return true;
        }
      }
    }
  }
  return false;
}

/// The first element of another property that the crack or its rosette touches.
std::optional<ElementId> foreign_element(const Host& host, const Placement& placement,
                                         const Cavity& cavity) {
  const model::Mesh& mesh = host.mesh();
  std::set<ElementId> others;
  for (const ElementId e : cavity.elements) {
    for (const NodeId n : mesh.nodes_of(e)) {
      for (const ElementId next : host.around(n)) {
        if (mesh.property[next.index()] != mesh.property[e.index()]) {
          others.insert(next);
        }
      }
    }
  }
  for (const ElementId e : others) {
    const std::vector<Vec2> shape = polygon(mesh, e, placement.frame);
    if (distance(shape, placement.line) < same ||
        distance(shape, {placement.tip(), placement.tip()}) < 1.1 * placement.radius) {
      return e;
    }
  }
  return std::nullopt;
}

} // namespace

std::vector<Vec2> polygon(const model::Mesh& mesh, ElementId e, const CrackFrame& frame) {
  std::vector<Vec2> result;
  for (int s = 0; s < base::info(mesh.type[e.index()]).sides; ++s) {
    const Edge edge = edge_of(mesh, {e, s});
    result.push_back(frame.local(mesh.x[edge.a.index()]));
    if (edge.mid.valid()) {
      result.push_back(frame.local(mesh.x[edge.mid.index()]));
    }
  }
  return result;
}

Cavity find_cavity(const Host& host, const Placement& placement) {
  return Finder(host, placement).find();
}

bool check_cavity(const Host& host, const Placement& placement, const Cavity& cavity,
                  base::Span span, base::Diagnostics& diagnostics) {
  const model::Mesh& mesh = host.mesh();
  if (const auto e = foreign_element(host, placement, cavity)) {
    diagnostics.error(span, "E424",
                      fmt::format("the crack or its rosette meets a material boundary at element "
                                  "{}",
                                  mesh.element_label[e->index()]),
                      "a patch has one property; give a smaller RADIUS on $TIPNET or move the "
                      "crack");
    return false;
  }
  if (placement.half == 0 && leaves_body(host, placement, cavity)) {
    diagnostics.error(span, "E425", "the crack leaves its body or runs along the boundary");
    return false;
  }
  for (const ElementId e : cavity.elements) {
    if (!base::info(mesh.type[e.index()]).quadratic) {
      diagnostics.error(span, "E426",
                        fmt::format("a crack patch needs quadratic elements round it, element {} "
                                    "is a {}",
                                    mesh.element_label[e.index()],
                                    base::info(mesh.type[e.index()]).name),
                        "use TRIMC6 or QUAMC8, TYPE=QUADRATIC on $IMPORT, or PATCH=NO");
      return false;
    }
  }
  return true;
}

} // namespace spricka::mesh
