// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/disjoint_sets.hpp"
#include "fe/dof_map.hpp"
#include "model/freedoms.hpp"

#include <numeric>

namespace spricka::fe {

std::vector<Body> find_bodies(const model::Mesh& mesh) {
  base::DisjointSets groups(mesh.node_count());
  for (std::size_t e = 0; e < mesh.element_count(); ++e) {
    const std::span<const base::NodeId> nodes = mesh.element_nodes(base::ElementId(e));
    for (const base::NodeId n : nodes) {
      groups.join_sets(nodes.front().index(), n.index());
    }
  }

  std::vector<Body> bodies;
  std::vector<std::int32_t> body_of_root(mesh.node_count(), -1);
  for (std::size_t e = 0; e < mesh.element_count(); ++e) {
    const base::ElementId id(e);
    std::int32_t& body = body_of_root[groups.root(mesh.element_nodes(id).front().index())];
    if (body < 0) {
      body = static_cast<std::int32_t>(bodies.size());
      bodies.push_back({mesh.element_net[e], {}, {}});
    }
    bodies[static_cast<std::size_t>(body)].elements.push_back(id);
  }
  // Nodes without an element have a root of their own, which no body knows.
  for (std::size_t n = 0; n < mesh.node_count(); ++n) {
    const std::int32_t body = body_of_root[groups.root(n)];
    if (body >= 0) {
      bodies[static_cast<std::size_t>(body)].nodes.emplace_back(n);
    }
  }
  return bodies;
}

std::vector<std::vector<Body>> join_tied_bodies(const model::Mesh& mesh, std::vector<Body> bodies,
                                                const ConstraintTransformation& ties,
                                                const std::vector<model::FreedomRole>& cls) {
  constexpr std::size_t none = static_cast<std::size_t>(-1);
  std::vector<std::size_t> body_of(mesh.node_count(), none);
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    for (const base::NodeId n : bodies[b].nodes) {
      body_of[n.index()] = b;
    }
  }
  const auto body_at = [&](std::int32_t freedom) {
    const auto node = static_cast<std::size_t>(freedom / mesh.dim);
    if (body_of[node] == none) {
      // A node that ties know but no element: a body by itself.
      body_of[node] = bodies.size();
      bodies.push_back({mesh.node_net[node], {}, {base::NodeId(node)}});
    }
    return body_of[node];
  };
  // All links before the groups: body_at adds bodies.
  std::vector<std::pair<std::size_t, std::size_t>> links;
  for (const ConstraintTransformation::DependentRow& row : ties.rows()) {
    const std::size_t first = body_at(row.freedom);
    for (const FreedomTerm& t : row.terms) {
      // A tie to a freedom that is held or given is a support and joins nothing.
      if (!model::is_suppressed_or_prescribed(cls[static_cast<std::size_t>(t.freedom)])) {
        links.emplace_back(first, body_at(t.freedom));
      }
    }
  }
  base::DisjointSets groups(bodies.size());
  for (const auto& [a, b] : links) {
    groups.join_sets(a, b);
  }
  std::vector<std::vector<Body>> joined(bodies.size());
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    joined[groups.root(b)].push_back(std::move(bodies[b]));
  }
  std::erase_if(joined, [](const std::vector<Body>& pieces) { return pieces.empty(); });
  return joined;
}

} // namespace spricka::fe
