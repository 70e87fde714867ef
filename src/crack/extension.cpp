// SPDX-License-Identifier: GPL-3.0-or-later
#include "crack/extension.hpp"

#include "mesh/boundary.hpp"
#include "shape/topology.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <set>

namespace spricka::crack {

namespace {

// Nodes that q may move although they lie on the boundary: the lips without the mouth, and in a
// half model the symmetry line ahead of the tip.
std::vector<bool> movable(const mesh::CrackedMesh& cracked, const mesh::Tip& tip,
                          std::vector<bool> boundary) {
  for (const mesh::CrackedMesh::Lips& lips : cracked.lips) {
    const bool embedded = !lips.left.empty() && !lips.right.empty() &&
                          lips.left.front() == lips.right.front(); // no mouth, a tip
    for (const std::vector<base::NodeId>* lip : {&lips.left, &lips.right}) {
      for (std::size_t i = embedded ? 0 : 1; i < lip->size(); ++i) {
        boundary[(*lip)[i].index()] = false;
      }
    }
  }
  if (tip.symmetric_half) {
    const base::Vec3 e2(-tip.direction.y(), tip.direction.x(), 0.0);
    for (std::size_t n = 0; n < boundary.size(); ++n) {
      const base::Vec3 d = cracked.mesh.x[n] - tip.x;
      if (std::abs(d.dot(e2)) < 1e-9 * tip.a && d.dot(tip.direction) > 0.0) {
        boundary[n] = false;
      }
    }
    boundary[tip.node.index()] = false;
  }
  return boundary;
}

} // namespace

Neighbourhood::Neighbourhood(const model::Mesh& mesh)
    : mesh_(mesh), elements_(mesh), boundary_(mesh.node_count(), false) {
  for (const base::NodeId n : mesh::nodes_of_faces(mesh, mesh::boundary_faces(mesh))) {
    boundary_[n.index()] = true;
  }
}

ExtensionField Neighbourhood::field(base::NodeId tip, int rings) const {
  std::set<base::NodeId> rigid{tip};
  std::set<base::ElementId> inside;
  std::set<base::ElementId> rim;
  for (int ring = 0; ring <= rings; ++ring) {
    rim.clear();
    for (const base::NodeId n : rigid) {
      for (const base::ElementId e : elements_.around(n)) {
        if (!inside.contains(e)) {
          rim.insert(e);
        }
      }
    }
    if (ring == rings) {
      break;
    }
    for (const base::ElementId e : rim) {
      inside.insert(e);
      const std::span<const base::NodeId> nodes = mesh_.nodes_of(e);
      rigid.insert(nodes.begin(), nodes.end());
    }
  }
  ExtensionField result;
  result.rings = rings;
  result.elements.assign(rim.begin(), rim.end());
  result.inside.assign(inside.begin(), inside.end());
  std::map<base::NodeId, double> q;
  for (const base::NodeId n : rigid) {
    q[n] = 1.0;
  }
  for (const base::ElementId e : rim) {
    const base::ElementType type = mesh_.type[e.index()];
    const std::span<const base::NodeId> nodes = mesh_.nodes_of(e);
    for (int s = 0; s < base::info(type).sides; ++s) {
      const std::span<const int> side = shape::side_nodes(type, s);
      if (side.size() == 3) {
        const base::NodeId a = nodes[static_cast<std::size_t>(side[0])];
        const base::NodeId b = nodes[static_cast<std::size_t>(side[1])];
        const base::NodeId mid = nodes[static_cast<std::size_t>(side[2])];
        const double mean =
            0.5 * ((rigid.contains(a) ? 1.0 : 0.0) + (rigid.contains(b) ? 1.0 : 0.0));
        if (!rigid.contains(mid) && mean > 0.0) {
          q[mid] = mean;
        }
      }
    }
  }
  result.q.assign(q.begin(), q.end());
  return result;
}

std::vector<ExtensionField> Neighbourhood::fields(const mesh::CrackedMesh& cracked,
                                                  const mesh::Tip& tip,
                                                  const std::vector<int>& rings,
                                                  std::vector<int>& left_out,
                                                  const DomainLimits& limits) const {
  std::vector<bool> fixed = movable(cracked, tip, boundary_);
  for (const mesh::Tip& other : cracked.tips) {
    if (other.node != tip.node) {
      fixed[other.node.index()] = true;
    }
  }
  for (std::size_t n = 0; n < limits.node.size(); ++n) {
    fixed[n] = fixed[n] || limits.node[n];
  }
  // One zone on each side of the tip's line; between two materials they differ.
  const auto zone = [&](base::ElementId e) -> std::int64_t {
    return limits.zone.empty() ? mesh_.property[e.index()].value : limits.zone[e.index()];
  };
  const auto on_left = [&](base::ElementId e) {
    base::Vec3 middle = base::Vec3::Zero();
    for (const base::NodeId n : mesh_.nodes_of(e)) {
      middle += mesh_.x[n.index()] - tip.x;
    }
    return tip.direction.x() * middle.y() - tip.direction.y() * middle.x() > 0.0;
  };
  std::array<std::int64_t, 2> side{-1, -1}; // right, left
  bool split = false;
  for (const base::ElementId e : elements_.around(tip.node)) {
    std::int64_t& own = side[on_left(e) ? 1 : 0];
    split = split || (own >= 0 && own != zone(e));
    own = zone(e);
  }
  const auto beyond = [&](base::ElementId e) {
    return split || zone(e) != side[on_left(e) ? 1 : 0];
  };
  std::vector<ExtensionField> result;
  for (const int count : rings) {
    ExtensionField f = field(tip.node, count);
    const bool moves_fixed = std::any_of(f.q.begin(), f.q.end(),
                                         [&](const auto& nq) { return fixed[nq.first.index()]; });
    const bool leaves = std::any_of(f.q.begin(), f.q.end(), [&](const auto& nq) {
      const std::span<const base::ElementId> around = elements_.around(nq.first);
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
