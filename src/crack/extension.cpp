// SPDX-License-Identifier: GPL-3.0-or-later
#include "crack/extension.hpp"

#include "crack/front_layers.hpp"
#include "shape/topology.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <utility>

namespace spricka::crack {

namespace {

// Nodes that q may move although they lie on the boundary: the faces of the tip's crack without the
// mouth, and in a half model the symmetry line ahead of the tip. Faces of another crack stay: moved
// along with this one they would release energy that is not its own.
class Movable {
public:
  Movable(const mesh::CrackedMesh& cracked, const mesh::CrackFront& front)
      : mesh_(cracked.mesh), front_(front) {
    const mesh::CrackFaceNodes& own = cracked.faces[front.crack.index()];
    const bool embedded = !own.left.empty() && !own.right.empty() &&
                          own.left.front() == own.right.front(); // no mouth, a tip
    for (const std::vector<base::NodeId>* crack_face : {&own.left, &own.right}) {
      // The mouth belongs to the outer boundary, which stays.
      crack_faces_.insert(crack_face->begin() + (embedded || crack_face->empty() ? 0 : 1),
                          crack_face->end());
    }
  }

  [[nodiscard]] bool contains(base::NodeId n) const {
    return crack_faces_.contains(n) ||
           (front_.symmetric_half && (n == front_.tip_point().node || is_ahead(n)));
  }

private:
  [[nodiscard]] bool is_ahead(base::NodeId n) const {
    const base::Vec3 e2(-front_.tip_point().growth.y(), front_.tip_point().growth.x(), 0.0);
    const base::Vec3 d = mesh_.x[n.index()] - front_.tip_point().x;
    // On the line to round-off, as a part of the crack's length.
    return std::abs(d.dot(e2)) < 1e-9 * front_.a && d.dot(front_.tip_point().growth) > 0.0;
  }

  const model::Mesh& mesh_;
  const mesh::CrackFront& front_;
  std::set<base::NodeId> crack_faces_;
};

} // namespace

TipNeighbourhood::TipNeighbourhood(const model::Mesh& mesh) : mesh_(mesh), elements_(mesh) {}

// A side that no other element has the corners of.
bool TipNeighbourhood::on_boundary(base::NodeId n) const {
  const auto has = [&](base::ElementId e, base::NodeId node) {
    const std::span<const base::NodeId> nodes = mesh_.element_nodes(e);
    return std::find(nodes.begin(), nodes.end(), node) != nodes.end();
  };
  for (const base::ElementId e : elements_.elements_around(n)) {
    const base::ElementType type = mesh_.type[e.index()];
    const std::span<const base::NodeId> nodes = mesh_.element_nodes(e);
    for (int s = 0; s < base::element_info(type).sides; ++s) {
      const std::span<const int> side = shape::side_nodes(type, s);
      const auto is_n = [&](int i) { return nodes[static_cast<std::size_t>(i)] == n; };
      if (std::none_of(side.begin(), side.end(), is_n)) {
        continue;
      }
      const std::span<const int> corners = side.first(shape::side_corner_count(type, s));
      const auto shares = [&](base::ElementId other) {
        return other != e && std::all_of(corners.begin(), corners.end(), [&](int i) {
                 return has(other, nodes[static_cast<std::size_t>(i)]);
               });
      };
      const std::span<const base::ElementId> around =
          elements_.elements_around(nodes[static_cast<std::size_t>(side[0])]);
      if (std::none_of(around.begin(), around.end(), shares)) {
        return true;
      }
    }
  }
  return false;
}

std::map<base::NodeId, double> VirtualExtensionField::extension_by_node() const {
  std::map<base::NodeId, double> by_node;
  for (const NodeMotion& moved : motion) {
    by_node.emplace_hint(by_node.end(), moved.node, moved.q);
  }
  return by_node;
}

VirtualExtensionField TipNeighbourhood::field(const mesh::CrackFront& front, int rings) const {
  // The last layer keeps the elements that q strains (crack.2).
  ElementLayersRoundFront layers = find_layers_round_front(mesh_, elements_, front, {}, rings + 1);
  VirtualExtensionField result;
  result.rings = rings;
  result.elements = std::move(layers.elements.back());
  layers.elements.pop_back();
  std::map<base::NodeId, double> q{{front.tip_point().node, 1.0}};
  for (const std::vector<base::ElementId>& layer : layers.elements) {
    result.inside.insert(result.inside.end(), layer.begin(), layer.end());
    for (const base::ElementId e : layer) {
      for (const base::NodeId n : mesh_.element_nodes(e)) {
        q[n] = 1.0;
      }
    }
  }
  std::ranges::sort(result.inside);
  for (const base::ElementId e : result.elements) {
    const base::ElementType type = mesh_.type[e.index()];
    const std::span<const base::NodeId> nodes = mesh_.element_nodes(e);
    for (int s = 0; s < base::element_info(type).sides; ++s) {
      const std::span<const int> side = shape::side_nodes(type, s);
      if (side.size() < 3) {
        continue;
      }
      const auto node = [&](std::size_t i) { return nodes[static_cast<std::size_t>(side[i])]; };
      // A middle node between a corner that moves and one that rests goes half the way.
      const double mean =
          0.5 * (layers.extension_factor(node(0), rings) + layers.extension_factor(node(1), rings));
      if (mean > 0.0) {
        q.try_emplace(node(2), mean);
      }
    }
  }
  for (const auto& [node, amount] : q) {
    result.motion.push_back({.node = node, .q = amount, .along = front.tip_point().growth});
  }
  return result;
}

std::vector<VirtualExtensionField>
TipNeighbourhood::extension_fields(const mesh::CrackedMesh& cracked, const mesh::CrackFront& front,
                                   const std::vector<int>& rings, std::vector<int>& left_out,
                                   const IntegrationDomainConstraints& limits) const {
  const Movable movable(cracked, front);
  const auto fixed = [&](base::NodeId n) {
    return (!limits.node.empty() && limits.node[n.index()]) ||
           std::ranges::any_of(cracked.fronts,
                               [&](const mesh::CrackFront& other) {
                                 return other.tip_point().node == n && n != front.tip_point().node;
                               }) ||
           (!movable.contains(n) && on_boundary(n));
  };
  // One zone on each side of the tip's line; between two materials they differ.
  const auto zone = [&](base::ElementId e) -> std::int64_t {
    return limits.zone.empty() ? mesh_.property[e.index()].value : limits.zone[e.index()];
  };
  const auto on_left = [&](base::ElementId e) {
    base::Vec3 middle = base::Vec3::Zero();
    for (const base::NodeId n : mesh_.element_nodes(e)) {
      middle += mesh_.x[n.index()] - front.tip_point().x;
    }
    // By the sum of the nodes' places: the sign is that of their mean.
    return front.tip_point().growth.x() * middle.y() - front.tip_point().growth.y() * middle.x() >
           0.0;
  };
  std::array<std::int64_t, 2> side{-1, -1}; // right, left
  bool split = false;
  for (const base::ElementId e : elements_.elements_around(front.tip_point().node)) {
    std::int64_t& own = side[on_left(e) ? 1 : 0];
    // A border that runs into the tip off its line: no domain has one zone on each side.
    split = split || (own >= 0 && own != zone(e));
    own = zone(e);
  }
  const auto beyond = [&](base::ElementId e) {
    return split || zone(e) != side[on_left(e) ? 1 : 0];
  };
  std::vector<VirtualExtensionField> result;
  for (const int count : rings) {
    VirtualExtensionField f = field(front, count);
    const bool moves_fixed =
        std::ranges::any_of(f.motion, [&](const NodeMotion& m) { return fixed(m.node); });
    const bool leaves = std::ranges::any_of(f.motion, [&](const NodeMotion& m) {
      const std::span<const base::ElementId> around = elements_.elements_around(m.node);
      return std::any_of(around.begin(), around.end(), beyond);
    });
    if (moves_fixed || leaves || f.elements.empty()) {
      left_out.push_back(count);
    } else {
      result.push_back(std::move(f));
    }
  }
  return result;
}

} // namespace spricka::crack
