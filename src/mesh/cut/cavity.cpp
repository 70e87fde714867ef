// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/cut/cavity.hpp"

#include "geometry/polyline.hpp"
#include "mesh/boundary.hpp"
#include "mesh/plane.hpp"

#include <algorithm>
#include <iterator>
#include <limits>
#include <map>
#include <optional>
#include <utility>

namespace spricka::mesh {
namespace {

using base::ElementId;
using base::NodeId;
using base::Vec2;

/// How near to the crack, in crack lengths, and to its tip, in rosette radii, the host's elements
/// are replaced: so near that triangles between would come out flat.
constexpr double reach_of_line = 0.3;
constexpr double reach_of_tip = 2.5;
/// Least distance of an edge that stays from the crack and the rosette, in its own lengths.
constexpr double edge_room = 1.2;

class CavityFinder {
public:
  /// `owner` tells of each element which cavity has it; `self` is the number of this one.
  CavityFinder(const HostMesh& host, std::vector<const CrackPlacement*> placements,
               std::vector<std::size_t>& owner, std::size_t self)
      : host_(host), mesh_(host.mesh()), places_(std::move(placements)), owner_(owner), self_(self),
        seed_(places_.front()->seed) {}

  /// Takes what the cracks need; returns the cavity that has some of it already, or none.
  std::size_t take_core() {
    std::vector<ElementId> front;
    for (const CrackPlacement* place : places_) {
      front.push_back(place->seed);
      // The seed has one edge at that node only: the crack may start into any other element there.
      if (place->mouth && place->mouth->node.valid()) {
        const auto around = host_.elements_around(place->mouth->node);
        std::copy_if(around.begin(), around.end(), std::back_inserter(front),
                     [&](ElementId e) { return allowed(e); });
      }
    }
    std::size_t other = none;
    for (const ElementId e : front) {
      other = take(e) ? other : owner_[e.index()];
    }
    while (!front.empty()) {
      const ElementId e = front.back();
      front.pop_back();
      for (int s = 0; s < base::element_info(mesh_.type[e.index()]).sides; ++s) {
        const auto next = host_.neighbour({e, s});
        // (mesh.2), over neighbours only: elements that are near but across a slit do not come in.
        if (!next || has(*next) || !allowed(*next) || !near(*next)) {
          continue;
        }
        if (take(*next)) {
          front.push_back(*next);
        } else {
          other = owner_[next->index()];
        }
      }
    }
    return other;
  }

  void take_layer() {
    // Over a copy, so that what is taken here brings no layer of its own. What another cavity has
    // stays with it.
    for (const ElementId e : elements()) {
      for (const NodeId n : mesh_.element_nodes(e)) {
        take_around(n);
      }
    }
  }

  /// Takes in what lies beyond edges that are long against their distance from the crack: triangles
  /// on them would come out flat, or, as they are seen as straight, reach over the crack. Returns
  /// the cavity that has some of it already, or none.
  std::size_t take_beyond_long_edges() {
    std::size_t other = none;
    // (mesh.3). What is taken moves the outline, whose new edges may be long as well.
    for (bool more = true; more;) {
      more = false;
      for (const model::Face& face : outline()) {
        const auto next = host_.neighbour(face);
        if (next && allowed(*next) && is_long(element_edge_nodes(mesh_, face))) {
          const bool taken = take(*next);
          other = taken ? other : owner_[next->index()];
          more = more || taken;
        }
      }
    }
    return other;
  }

  /// A loop that meets itself at a node could not be meshed: takes in what lies round such nodes.
  /// Returns the cavity that has some of it already, or none.
  std::size_t take_pinched() {
    for (bool more = true; more;) {
      std::map<NodeId, int> leaving;
      for (const model::Face& face : outline()) {
        ++leaving[element_edge_nodes(mesh_, face).a];
      }
      more = false;
      for (const auto& [node, count] : leaving) {
        // An outline leaves each of its nodes once, but where two stretches of it touch.
        if (count > 1) {
          if (!take_around(node)) {
            return other_around(node);
          }
          more = true;
        }
      }
    }
    return none;
  }

  [[nodiscard]] Cavity cavity() const {
    Cavity result;
    result.elements = elements();
    for (const FaceChain& chain : build_face_chains(mesh_, outline())) {
      std::vector<CavityOutlineEdge> loop;
      for (const model::Face& face : chain.faces) {
        loop.push_back({face, element_edge_nodes(mesh_, face), !host_.neighbour(face).has_value()});
      }
      result.loops.push_back(std::move(loop));
    }
    return result;
  }

  static constexpr std::size_t none = std::numeric_limits<std::size_t>::max();

private:
  [[nodiscard]] bool has(ElementId e) const { return owner_[e.index()] == self_; }
  bool take(ElementId e) {
    std::size_t& owner = owner_[e.index()];
    if (owner == none) {
      owner = self_;
      taken_.push_back(e);
    }
    return owner == self_;
  }
  [[nodiscard]] bool allowed(ElementId e) const {
    // A patch has one net and one property, those of the element that the crack starts in.
    return mesh_.element_net[e.index()] == mesh_.element_net[seed_.index()] &&
           mesh_.property[e.index()] == mesh_.property[seed_.index()];
  }
  [[nodiscard]] bool near(ElementId e) const {
    return std::ranges::any_of(places_, [&](const CrackPlacement* place) {
      // In the frame of each crack, where its length a is 1.
      const std::vector<Vec2> shape = element_polygon_in_frame(mesh_, e, place->frame);
      return distance(shape, place->line) < reach_of_line + coordinate_tolerance ||
             std::ranges::any_of(place->fronts, [&](const PlacedTip& tip) {
               return distance(shape, {tip.at, tip.at}) <
                      reach_of_tip * place->radius + coordinate_tolerance;
             });
    });
  }
  [[nodiscard]] bool is_long(const EdgeEndAndMidNodes& edge) const {
    return std::ranges::any_of(places_, [&](const CrackPlacement* place) {
      return mesh::is_edge_longer_than_clearance(mesh_, *place, edge, 1.0 / edge_room);
    });
  }
  [[nodiscard]] std::vector<ElementId> elements() const {
    std::vector<ElementId> result = taken_;
    std::sort(result.begin(), result.end());
    return result;
  }

  /// True if anything was taken.
  bool take_around(NodeId n) {
    bool more = false;
    for (const ElementId e : host_.elements_around(n)) {
      more = (!has(e) && allowed(e) && take(e)) || more;
    }
    return more;
  }

  [[nodiscard]] std::size_t other_around(NodeId n) const {
    for (const ElementId e : host_.elements_around(n)) {
      if (!has(e) && owner_[e.index()] != none) {
        return owner_[e.index()];
      }
    }
    return none;
  }

  [[nodiscard]] std::vector<model::Face> outline() const {
    return host_.sides_facing_outside(elements(), [&](ElementId e) { return has(e); });
  }

  const HostMesh& host_;
  const model::Mesh& mesh_;
  std::vector<const CrackPlacement*> places_;
  std::vector<std::size_t>& owner_;
  std::size_t self_;
  ElementId seed_;
  std::vector<ElementId> taken_;
};

/// Every cavity takes what it wants; returns two that want the same, if there are.
std::optional<std::pair<std::size_t, std::size_t>> take_all(std::vector<CavityFinder>& finders) {
  // All cores before the first layer: a crack cannot do without its core, layers give way.
  for (std::size_t i = 0; i < finders.size(); ++i) {
    if (const std::size_t other = finders[i].take_core(); other != CavityFinder::none) {
      return std::pair(other, i);
    }
  }
  for (std::size_t i = 0; i < finders.size(); ++i) {
    finders[i].take_layer();
    if (const std::size_t other = finders[i].take_beyond_long_edges();
        other != CavityFinder::none) {
      return std::pair(other, i);
    }
    if (const std::size_t other = finders[i].take_pinched(); other != CavityFinder::none) {
      return std::pair(other, i);
    }
  }
  return std::nullopt;
}

} // namespace

bool is_edge_longer_than_clearance(const model::Mesh& mesh, const CrackPlacement& placement,
                                   const EdgeEndAndMidNodes& edge, double part) {
  const Vec2 a = placement.frame.rounded_local_coordinates(mesh.x[edge.a.index()]).head<2>();
  const Vec2 b = placement.frame.rounded_local_coordinates(mesh.x[edge.b.index()]).head<2>();
  // The edge's chord as a polygon without area.
  double room = distance({a, b, a}, placement.line);
  for (const PlacedTip& tip : placement.fronts) {
    room = std::min(room, geometry::distance_to_segment(tip.at, a, b) - placement.radius);
  }
  return part * room < (b - a).norm() - coordinate_tolerance;
}

Cavities find_cavities(const HostMesh& host, std::span<const CrackPlacement> placements) {
  std::vector<std::vector<std::size_t>> groups;
  for (std::size_t i = 0; i < placements.size(); ++i) {
    groups.push_back({i});
  }
  std::vector<CavityFinder> finders;
  std::vector<std::size_t> owner;
  for (bool more = true; more;) { // until no two of them want the same elements
    owner.assign(host.mesh().element_count(), CavityFinder::none);
    finders.clear();
    for (std::size_t g = 0; g < groups.size(); ++g) {
      std::vector<const CrackPlacement*> members;
      for (const std::size_t i : groups[g]) {
        members.push_back(&placements[i]);
      }
      finders.emplace_back(host, std::move(members), owner, g);
    }
    const auto clash = take_all(finders);
    more = clash.has_value();
    if (clash) {
      // Both become one, under the lower number: its first crack gives the frame of the patch. Then
      // all are found anew, as layers may have given way to what is no cavity any more.
      const auto [a, b] = std::minmax(clash->first, clash->second);
      groups[a].insert(groups[a].end(), groups[b].begin(), groups[b].end());
      std::sort(groups[a].begin(), groups[a].end());
      groups.erase(groups.begin() + static_cast<std::ptrdiff_t>(b));
    }
  }
  Cavities result;
  for (const CavityFinder& finder : finders) {
    result.each.push_back(finder.cavity());
  }
  result.cracks = std::move(groups);
  return result;
}

} // namespace spricka::mesh
