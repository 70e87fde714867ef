// SPDX-License-Identifier: GPL-3.0-or-later
#include "crack/front_layers.hpp"

#include "mesh/boundary.hpp"
#include "mesh/side_index.hpp"
#include "shape/topology.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <set>

namespace spricka::crack {

namespace {

using base::ElementId;
using base::NodeId;

// The mid node of the edge from a to b, of any element that has it; a itself: an edge without one.
NodeId middle_of_edge(const model::Mesh& mesh, const mesh::NodeToElementsMap& elements, NodeId a,
                      NodeId b) {
  for (const ElementId e : elements.elements_around(a)) {
    const base::ElementType type = mesh.type[e.index()];
    const std::span<const NodeId> nodes = mesh.element_nodes(e);
    for (int m = 0; m < shape::edge_count(type); ++m) {
      const auto ends = shape::edge_corners(type, m);
      const NodeId p = nodes[static_cast<std::size_t>(ends[0])];
      const NodeId q = nodes[static_cast<std::size_t>(ends[1])];
      if ((p == a && q == b) || (p == b && q == a)) {
        const base::ElementInfo& info = base::element_info(type);
        return info.quadratic ? nodes[static_cast<std::size_t>(info.corners + m)] : a;
      }
    }
  }
  return {};
}

} // namespace

FrontMidNodes front_mid_nodes(const model::Mesh& mesh, const mesh::NodeToElementsMap& elements,
                              const mesh::CrackFront& front) {
  FrontMidNodes line;
  const std::size_t count = front.points.size();
  line.middle.resize(count);
  for (std::size_t i = 0; i < count; ++i) {
    const NodeId a = front.points[i].node;
    const NodeId b = front.points[(i + 1) % count].node;
    const bool last = i + 1 == count;
    if (last && count < 3) {
      break;
    }
    const NodeId middle = middle_of_edge(mesh, elements, a, b);
    line.closed = line.closed || (last && middle.valid());
    if (middle.valid() && middle != a) {
      line.middle[i] = middle;
    }
  }
  return line;
}

ElementLayersRoundFront find_layers_round_front(const model::Mesh& mesh,
                                                const mesh::NodeToElementsMap& elements,
                                                const mesh::CrackFront& front,
                                                const FrontMidNodes& line, int count) {
  ElementLayersRoundFront layers;
  layers.of_node.assign(mesh.node_count(), -1);
  std::vector<NodeId> rim;
  const auto reach = [&](NodeId n, int layer) {
    if (layers.of_node[n.index()] < 0) {
      layers.of_node[n.index()] = layer;
      rim.push_back(n);
    }
  };
  for (const mesh::FrontPoint& point : front.points) {
    reach(point.node, 0);
  }
  for (const NodeId n : line.middle) {
    if (n.valid()) {
      reach(n, 0);
    }
  }
  std::vector<bool> taken(mesh.element_count(), false);
  for (int layer = 1; layer <= count; ++layer) {
    std::vector<ElementId> fresh;
    for (const NodeId n : rim) {
      for (const ElementId e : elements.elements_around(n)) {
        if (!taken[e.index()]) {
          taken[e.index()] = true;
          fresh.push_back(e);
        }
      }
    }
    std::ranges::sort(fresh);
    rim.clear();
    for (const ElementId e : fresh) {
      for (const NodeId n : mesh.element_nodes(e)) {
        reach(n, layer);
      }
    }
    layers.elements.push_back(std::move(fresh));
  }
  return layers;
}

// Along the rim of a tube of hexahedra two triangles meet one quadrilateral: the program that cuts
// the crack ties the middle of the diagonal, and nothing is free there.
std::vector<model::Face> free_sides(const model::Mesh& mesh,
                                    const std::vector<ElementId>& elements) {
  const mesh::SideIndex index(mesh);
  std::set<model::Face> joined;
  const auto alone = [&](std::array<NodeId, 3> corners) {
    const std::span<const model::Face> found = index.find(corners);
    return found.size() == 1 ? std::optional(found.front()) : std::nullopt;
  };
  std::vector<model::Face> sides;
  for (const ElementId e : elements) {
    for (int s = 0; s < base::element_info(mesh.type[e.index()]).sides; ++s) {
      const model::Face face{e, s};
      if (index.find(mesh::face_nodes(mesh, face).corner_nodes()).size() == 1) {
        sides.push_back(face);
      }
    }
  }
  const auto look = [&](const model::Face& face) {
    const mesh::FaceNodes nodes = mesh::face_nodes(mesh, face);
    const std::span<const NodeId> c = nodes.corner_nodes();
    for (std::size_t k = 0; k < 2 && c.size() == 4; ++k) {
      const auto one = alone({c[k], c[k + 1], c[k + 2]});
      const auto other = alone({c[k + 2], c[(k + 3) % 4], c[k]});
      if (one && other) {
        joined.insert({face, *one, *other});
      }
    }
  };
  // The quadrilateral may belong to an element beyond these: all sides that are alone are asked.
  for (const model::Face& face : index.unshared_sides()) {
    look(face);
  }
  std::erase_if(sides, [&](const model::Face& face) { return joined.contains(face); });
  return sides;
}

} // namespace spricka::crack
