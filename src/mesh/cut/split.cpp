// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/cut/split.hpp"

#include "mesh/cut/crack_node_fan.hpp"
#include "mesh/cut/host.hpp"
#include "mesh/numbering.hpp"

#include <algorithm>
#include <map>
#include <set>

namespace spricka::mesh {
namespace {

using base::ElementId;
using base::NodeId;

/// Of the elements round a node of a path those on its right; empty if they hang together with
/// those on its left. `cut` holds the edges of the path as (from, to).
std::optional<std::vector<ElementId>>
right_of_path(const model::Mesh& mesh, NodeId node, const std::vector<ElementId>& elements,
              const std::set<std::pair<NodeId, NodeId>>& cut) {
  CrackNodeFan fan(elements.size());
  std::map<std::pair<NodeId, NodeId>, std::size_t> first; // edge -> element that has it
  for (std::size_t i = 0; i < elements.size(); ++i) {
    for (int s = 0; s < base::element_info(mesh.type[elements[i].index()]).sides; ++s) {
      const EdgeEndAndMidNodes edge = element_edge_nodes(mesh, {elements[i], s});
      if (edge.a != node && edge.b != node && edge.mid != node) {
        continue;
      }
      // An edge has its element on the left: one that runs with the path belongs to the left face.
      if (cut.contains({edge.a, edge.b})) {
        fan.add_side_on_crack(i, CrackFaceOfElement::left);
      } else if (cut.contains({edge.b, edge.a})) {
        fan.add_side_on_crack(i, CrackFaceOfElement::right);
      } else {
        fan.join_elements(i, first.try_emplace(std::minmax(edge.a, edge.b), i).first->second);
      }
    }
  }
  const std::vector<CrackFaceOfElement> sides = fan.crack_face_of_each_element();
  std::vector<ElementId> right;
  for (std::size_t i = 0; i < elements.size(); ++i) {
    if (sides[i] == CrackFaceOfElement::both) {
      return std::nullopt;
    }
    if (sides[i] == CrackFaceOfElement::right) {
      right.push_back(elements[i]);
    }
  }
  return right;
}

} // namespace

std::optional<CrackFaceNodes>
open_crack_along_path(model::Mesh& mesh, const std::vector<NodeId>& path, bool embedded) {
  std::map<NodeId, std::vector<ElementId>> around;
  for (const NodeId n : path) {
    around[n];
  }
  std::set<NodeId> corners;
  const std::vector<bool> on_path = model::mark_members(mesh.node_count(), path);
  for (std::size_t e = 0; e < mesh.element_count(); ++e) {
    const auto nodes = mesh.element_nodes(ElementId(e));
    const auto count = static_cast<std::size_t>(base::element_info(mesh.type[e]).corners);
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      if (on_path[nodes[i].index()]) {
        around[nodes[i]].emplace_back(e);
        if (i < count) {
          corners.insert(nodes[i]);
        }
      }
    }
  }
  std::set<std::pair<NodeId, NodeId>> cut;
  NodeId last;
  for (const NodeId n : path) {
    if (corners.contains(n)) {
      if (last.valid()) {
        cut.insert({last, n});
      }
      last = n;
    }
  }
  // Sides of all nodes first: the path's edges are known by the nodes they have before any is
  // doubled.
  std::vector<std::vector<ElementId>> right;
  const std::size_t first = embedded ? 1 : 0; // tips stay single
  for (std::size_t i = first; i + 1 < path.size(); ++i) {
    auto elements = right_of_path(mesh, path[i], around[path[i]], cut);
    if (!elements) {
      return std::nullopt;
    }
    right.push_back(std::move(*elements));
  }
  CrackFaceNodes crack_faces{path, {}};
  // Tips are nodes of both faces.
  if (embedded) {
    crack_faces.right.push_back(path.front());
  }
  const base::NetId net = mesh.node_net[path[0].index()];
  base::Label label = next_node_label(mesh, net);
  for (std::size_t i = first; i + 1 < path.size(); ++i) {
    const base::Vec3 x = mesh.x[path[i].index()];
    const NodeId twin = model::add_node(mesh, x, label++, net);
    for (const ElementId e : right[i - first]) {
      const auto begin = mesh.nodes.begin() + mesh.first[e.index()];
      std::replace(begin, mesh.nodes.begin() + mesh.first[e.index() + 1], path[i], twin);
    }
    crack_faces.right.push_back(twin);
  }
  crack_faces.right.push_back(path.back());
  return crack_faces;
}

namespace {

/// Calls f(other end, middle) for the quadratic edges at a tip, element by element.
template <class F> void for_edges_at(const model::Mesh& mesh, NodeId tip, F&& f) {
  for (std::size_t e = 0; e < mesh.element_count(); ++e) {
    const auto nodes = mesh.element_nodes(ElementId(e));
    if (std::find(nodes.begin(), nodes.end(), tip) == nodes.end()) {
      continue;
    }
    for (int s = 0; s < base::element_info(mesh.type[e]).sides; ++s) {
      const EdgeEndAndMidNodes edge = element_edge_nodes(mesh, {ElementId(e), s});
      if (edge.mid.valid() && (edge.a == tip || edge.b == tip)) {
        f(edge.a == tip ? edge.b : edge.a, edge.mid);
      }
    }
  }
}

} // namespace

double worst_mid_node_position(const model::Mesh& mesh, NodeId tip) {
  double odd = 0.5;
  const auto off = [](double part) {
    return std::min(std::abs(part - 0.25), std::abs(part - 0.5));
  };
  const base::Vec3& x = mesh.x[tip.index()];
  for_edges_at(mesh, tip, [&](NodeId other, NodeId mid) {
    const base::Vec3 side = mesh.x[other.index()] - x;
    const double part = (mesh.x[mid.index()] - x).dot(side) / side.squaredNorm();
    odd = off(part) > off(odd) ? part : odd;
  });
  return odd;
}

int make_quarter_point_edges(model::Mesh& mesh, NodeId tip) {
  int moved = 0;
  for_edges_at(mesh, tip, [&](NodeId other, NodeId mid) {
    const base::Vec3& x = mesh.x[tip.index()];
    // On the chord: on a straight edge only the distance goes with the square (shape.13).
    const base::Vec3 quarter = x + 0.25 * (mesh.x[other.index()] - x);
    mesh.x[mid.index()] = quarter;
    ++moved;
  });
  return moved;
}

} // namespace spricka::mesh
