// SPDX-License-Identifier: GPL-3.0-or-later
#include "estimate/tip_motion.hpp"

#include "shape/topology.hpp"

#include <algorithm>
#include <limits>
#include <map>
#include <utility>

namespace spricka::estimate {

namespace {

constexpr double share = 1e-4; ///< of a side: leaves 1e-8 of the derivative

double shortest_side(const model::Mesh& mesh, const std::vector<base::ElementId>& elements) {
  double shortest = std::numeric_limits<double>::infinity();
  for (const base::ElementId e : elements) {
    const base::ElementType type = mesh.type[e.index()];
    const std::span<const base::NodeId> nodes = mesh.element_nodes(e);
    for (int s = 0; s < base::element_info(type).sides; ++s) {
      const std::span<const int> side = shape::side_nodes(type, s);
      const base::Vec3 chord = mesh.x[nodes[static_cast<std::size_t>(side[1])].index()] -
                               mesh.x[nodes[static_cast<std::size_t>(side[0])].index()];
      shortest = std::min(shortest, chord.norm());
    }
  }
  return shortest;
}

} // namespace

TipMeshMotion make_tip_mesh_motion(const mesh::CrackedMesh& cracked, std::size_t tip,
                                   crack::VirtualExtensionField field) {
  const double step = share * shortest_side(cracked.mesh, field.elements);
  return {tip, std::move(field), step};
}

mesh::CrackedMesh move_tip_mesh(const mesh::CrackedMesh& cracked, const TipMeshMotion& motion,
                                double by) {
  mesh::CrackedMesh out = cracked;
  // The tip's place goes along with its node: near-tip fields start from it.
  mesh::CrackFront& front = out.fronts[motion.tip];
  for (const crack::NodeMotion& m : motion.field.motion) {
    out.mesh.x[m.node.index()] += (by * motion.step * m.q) * m.along;
  }
  front.tip_point().x += (by * motion.step) * front.tip_point().growth;
  front.a += by * motion.step;
  return out;
}

bool moves_domains_rigidly(const model::Mesh& mesh, const TipMeshMotion& motion,
                           const std::vector<crack::VirtualExtensionField>& fields) {
  const std::map<base::NodeId, double> q = motion.field.extension_by_node();
  bool all = true;
  bool none = true;
  for (const crack::VirtualExtensionField& field : fields) {
    for (const base::ElementId e : field.elements) {
      for (const base::NodeId n : mesh.element_nodes(e)) {
        const auto at = q.find(n);
        all = all && at != q.end() && at->second == 1.0;
        none = none && at == q.end();
      }
    }
  }
  return all || none;
}

} // namespace spricka::estimate
