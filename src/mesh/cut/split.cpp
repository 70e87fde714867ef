// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/cut/split.hpp"

#include "mesh/cut/host.hpp"
#include "mesh/numbering.hpp"

#include <algorithm>
#include <map>
#include <numeric>
#include <set>

namespace spricka::mesh {
namespace {

using base::ElementId;
using base::NodeId;

enum class PathSide { unknown, left, right, both };

PathSide join(PathSide a, PathSide b) {
  // Elements that both sides claim hang together round the node: the path does not part them.
  if (a == PathSide::unknown || a == b) {
    return b;
  }
  return b == PathSide::unknown ? a : PathSide::both;
}

/// Elements round one node of a path, told apart by the path's edges.
class Fan {
public:
  Fan(const model::Mesh& mesh, std::vector<ElementId> elements)
      : mesh_(mesh), elements_(std::move(elements)), root_(elements_.size()),
        side_(elements_.size(), PathSide::unknown) {
    std::iota(root_.begin(), root_.end(), std::size_t{0});
  }

  /// `cut` holds the edges of the path as (from, to).
  void part(NodeId node, const std::set<std::pair<NodeId, NodeId>>& cut) {
    std::map<std::pair<NodeId, NodeId>, std::size_t> first; // edge -> element that has it
    for (std::size_t i = 0; i < elements_.size(); ++i) {
      const int sides = base::element_info(mesh_.type[elements_[i].index()]).sides;
      for (int s = 0; s < sides; ++s) {
        const ElementEdge edge = element_edge(mesh_, {elements_[i], s});
        if (edge.a != node && edge.b != node && edge.mid != node) {
          continue;
        }
        // An edge has its element on the left: one that runs with the path belongs to the left
        // face.
        if (cut.contains({edge.a, edge.b})) {
          side_[i] = join(side_[i], PathSide::left);
        } else if (cut.contains({edge.b, edge.a})) {
          side_[i] = join(side_[i], PathSide::right);
        } else {
          const auto [at, fresh] = first.try_emplace(std::minmax(edge.a, edge.b), i);
          // Elements that share an edge off the path hang together.
          root_[find(i)] = find(at->second);
        }
      }
    }
  }

  /// Elements on the right; empty optional if they hang together with those on the left.
  std::optional<std::vector<ElementId>> right() {
    std::vector<PathSide> of_root(elements_.size(), PathSide::unknown);
    for (std::size_t i = 0; i < elements_.size(); ++i) {
      of_root[find(i)] = join(of_root[find(i)], side_[i]);
    }
    std::vector<ElementId> result;
    for (std::size_t i = 0; i < elements_.size(); ++i) {
      if (of_root[find(i)] == PathSide::both) {
        return std::nullopt;
      }
      if (of_root[find(i)] == PathSide::right) {
        result.push_back(elements_[i]);
      }
    }
    return result;
  }

private:
  std::size_t find(std::size_t i) {
    while (root_[i] != i) {
      i = root_[i];
    }
    return i;
  }

  const model::Mesh& mesh_;
  std::vector<ElementId> elements_;
  std::vector<std::size_t> root_;
  std::vector<PathSide> side_;
};

} // namespace

std::optional<CrackFaces> split_along(model::Mesh& mesh, const std::vector<NodeId>& path,
                                      bool embedded) {
  std::map<NodeId, std::vector<ElementId>> around;
  for (const NodeId n : path) {
    around[n];
  }
  std::set<NodeId> corners;
  std::vector<bool> on_path(mesh.node_count(), false);
  for (const NodeId n : path) {
    on_path[n.index()] = true;
  }
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
    Fan fan(mesh, around[path[i]]);
    fan.part(path[i], cut);
    std::optional<std::vector<ElementId>> elements = fan.right();
    if (!elements) {
      return std::nullopt;
    }
    right.push_back(std::move(*elements));
  }
  CrackFaces crack_faces{path, {}};
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

double worst_mid_node(const model::Mesh& mesh, NodeId tip) {
  double odd = 0.5;
  const auto off = [](double part) {
    return std::min(std::abs(part - 0.25), std::abs(part - 0.5));
  };
  for (std::size_t e = 0; e < mesh.element_count(); ++e) {
    const auto nodes = mesh.element_nodes(ElementId(e));
    if (std::find(nodes.begin(), nodes.end(), tip) == nodes.end()) {
      continue;
    }
    for (int s = 0; s < base::element_info(mesh.type[e]).sides; ++s) {
      const ElementEdge edge = element_edge(mesh, {ElementId(e), s});
      if (edge.mid.valid() && (edge.a == tip || edge.b == tip)) {
        const base::Vec3& x = mesh.x[tip.index()];
        const base::Vec3 side = mesh.x[(edge.a == tip ? edge.b : edge.a).index()] - x;
        const double part = (mesh.x[edge.mid.index()] - x).dot(side) / side.squaredNorm();
        odd = off(part) > off(odd) ? part : odd;
      }
    }
  }
  return odd;
}

int move_quarter_points(model::Mesh& mesh, NodeId tip) {
  int moved = 0;
  for (std::size_t e = 0; e < mesh.element_count(); ++e) {
    const auto nodes = mesh.element_nodes(ElementId(e));
    if (std::find(nodes.begin(), nodes.end(), tip) == nodes.end()) {
      continue;
    }
    for (int s = 0; s < base::element_info(mesh.type[e]).sides; ++s) {
      const ElementEdge edge = element_edge(mesh, {ElementId(e), s});
      if (edge.mid.valid() && (edge.a == tip || edge.b == tip)) {
        const NodeId other = edge.a == tip ? edge.b : edge.a;
        const base::Vec3& x = mesh.x[tip.index()];
        // On the chord: on a straight edge only the distance goes with the square (shape.13).
        const base::Vec3 quarter = x + 0.25 * (mesh.x[other.index()] - x);
        mesh.x[edge.mid.index()] = quarter;
        ++moved;
      }
    }
  }
  return moved;
}

} // namespace spricka::mesh
