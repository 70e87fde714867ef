// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/scene/gone_nodes.hpp"

#include "fe/side_stress.hpp"
#include "mesh/boundary.hpp"
#include "mesh/numbering.hpp"
#include "model/model.hpp"

#include <algorithm>

#include <fmt/format.h>

namespace spricka::analysis {

namespace {

using base::NodeId;

/// Nodes of the net that lost their elements, ascending; empty without a patch. In space, where
/// results are asked for at places and whole sides, nobody looks for them.
std::vector<NodeId> gone_nodes(const model::Mesh& host, const model::Mesh& cracked) {
  std::vector<NodeId> gone;
  // Gone nodes keep their numbers, so that a patch always adds nodes.
  if (host.dim == 3 || host.node_count() == cracked.node_count()) {
    return gone;
  }
  const std::vector<bool> before = model::mark_nodes_in_use(host);
  const std::vector<bool> now = model::mark_nodes_in_use(cracked);
  for (std::size_t n = 0; n < host.node_count(); ++n) {
    if (before[n] && !now[n]) {
      gone.emplace_back(n);
    }
  }
  return gone;
}

/// Elements that no net has: those of patches stand behind the kept ones of the host.
std::vector<base::ElementId> patch_elements(const model::Mesh& host, const model::Mesh& cracked) {
  std::vector<base::ElementId> elements;
  for (std::size_t e = 0; e < cracked.element_count(); ++e) {
    const auto nodes = cracked.element_nodes(base::ElementId(e));
    if (std::ranges::any_of(nodes, [&](NodeId n) { return n.index() >= host.node_count(); })) {
      elements.emplace_back(e);
    }
  }
  return elements;
}

std::vector<fe::PointElementGroup> sides_at(const model::Mesh& cracked, const base::Vec3& x,
                                            const fe::ElementBoxes& patch) {
  // Nearly always the patch has the place; the whole mesh is searched only where it has not.
  const std::vector<fe::ElementHit> hits = patch.elements_at(x);
  return fe::group_elements_at_point(cracked,
                                     hits.empty() ? fe::elements_at_point(cracked, x) : hits);
}

/// Nodes without elements behind those of the host: second sides of gone ones.
std::vector<NodeId> second_nodes(const model::Mesh& host, const model::Mesh& cracked) {
  const std::vector<bool> now = model::mark_nodes_in_use(cracked);
  std::vector<NodeId> second;
  for (std::size_t n = host.node_count(); n < cracked.node_count(); ++n) {
    if (!now[n]) {
      second.emplace_back(n);
    }
  }
  return second;
}

std::vector<bool> marked(std::size_t count, const std::vector<NodeId>& nodes) {
  std::vector<bool> in(count, false);
  for (const NodeId n : nodes) {
    in[n.index()] = true;
  }
  return in;
}

/// [gone node] nodes with elements at its place, and nodes that stand for its further sides.
struct Company {
  std::vector<NodeId> same_place, second;
};

std::vector<Company> company_of(const std::vector<NodeId>& gone, const model::Mesh& host,
                                const model::Mesh& cracked) {
  constexpr double same = 1e-9;
  const std::vector<bool> now = model::mark_nodes_in_use(cracked);
  base::Vec3 low = cracked.x.front();
  base::Vec3 high = low;
  for (const NodeId n : gone) {
    low = low.cwiseMin(cracked.x[n.index()]);
    high = high.cwiseMax(cracked.x[n.index()]);
  }
  // Round-off of coordinates, also far from the origin.
  const double near = same * std::max((high - low).norm(), low.norm());
  std::vector<Company> company(gone.size());
  for (std::size_t n = host.node_count(); n < cracked.node_count(); ++n) {
    for (std::size_t g = 0; g < gone.size(); ++g) {
      if ((cracked.x[n] - cracked.x[gone[g].index()]).squaredNorm() <= near * near) {
        (now[n] ? company[g].same_place : company[g].second).emplace_back(n);
      }
    }
  }
  return company;
}

} // namespace

void add_second_side_nodes(const model::Mesh& host, model::Mesh& cracked) {
  const std::vector<NodeId> gone = gone_nodes(host, cracked);
  const fe::ElementBoxes patch(cracked, patch_elements(host, cracked));
  for (const NodeId n : gone) {
    const std::size_t sides = sides_at(cracked, cracked.x[n.index()], patch).size();
    for (std::size_t s = 1; s < sides; ++s) {
      const base::Vec3 x = cracked.x[n.index()];
      const base::NetId net = cracked.node_net[n.index()];
      model::add_node(cracked, x, mesh::next_node_label(cracked, net), net);
    }
  }
}

std::vector<RemovedNodePlace> locate_removed_nodes(const model::Mesh& host,
                                                   const model::Mesh& cracked) {
  const std::vector<NodeId> gone = gone_nodes(host, cracked);
  if (gone.empty()) {
    return {};
  }
  const fe::ElementBoxes patch(cracked, patch_elements(host, cracked));
  const std::vector<NodeId> second = second_nodes(host, cracked);
  std::vector<RemovedNodePlace> places;
  for (const NodeId n : gone) {
    const base::Vec3& x = cracked.x[n.index()];
    const std::vector<fe::PointElementGroup> sides = sides_at(cracked, x, patch);
    std::size_t s = 0;
    if (s < sides.size()) {
      places.push_back({n, sides[s++]});
    }
    for (std::size_t k = 0; k < second.size() && s < sides.size(); ++k) {
      if (cracked.x[second[k].index()] == x) {
        places.push_back({second[k], sides[s++]});
      }
    }
  }
  return places;
}

void note_removed_nodes(const model::Model& model, Discretisation& scene) {
  if (scene.cracked.unreplaced_set_nodes.empty()) {
    return;
  }
  std::vector<bool> named(model.mesh.node_count(), false);
  for (std::size_t s = 0; s < model.mesh.node_sets.size(); ++s) {
    const bool removed =
        s < scene.cracked.unreplaced_set_nodes.size() && !model.mesh.node_sets[s].name.empty();
    for (const NodeId n : removed ? scene.cracked.unreplaced_set_nodes[s] : std::vector<NodeId>()) {
      named[n.index()] = true;
    }
  }
  const auto count = std::ranges::count(named, true);
  if (count == 0) {
    return;
  }
  const auto double_sided =
      static_cast<std::ptrdiff_t>(second_nodes(model.mesh, scene.cracked.mesh).size());
  scene.notes.push_back(fmt::format(
      "{} nodes of named sets lie in patches of cracks: results of the sets are those at their "
      "places{}",
      count,
      double_sided > 0 ? fmt::format(" ({} nodes of the net lie on crack faces, with a value on "
                                     "each)",
                                     double_sided)
                       : ""));
}

void fill_removed_node_displacements(const model::Mesh& cracked,
                                     const std::vector<RemovedNodePlace>& places, base::Vector& u) {
  for (const RemovedNodePlace& place : places) {
    const base::Vec3 value = fe::displacement_at(cracked, u, place.side);
    u.segment(static_cast<Eigen::Index>(place.node.index()) * cracked.dim, cracked.dim) =
        value.head(cracked.dim);
  }
}

void fill_removed_node_stresses(const model::Model& model, const model::Mesh& cracked,
                                const fe::DisplacementTemperatureField& field,
                                std::vector<fe::Stress>& nodal) {
  for (const RemovedNodePlace& place : locate_removed_nodes(model.mesh, cracked)) {
    nodal[place.node.index()] = fe::stress_of_element_group(model, cracked, field, place.side);
  }
}

void keep_removed_set_members(const model::Mesh& host, model::Mesh& cracked) {
  const std::vector<NodeId> gone = gone_nodes(host, cracked);
  if (gone.empty()) {
    return;
  }
  const std::vector<Company> company = company_of(gone, host, cracked);
  for (std::size_t s = 0; s < host.node_sets.size(); ++s) {
    const std::vector<bool> before = marked(host.node_count(), host.node_sets[s].nodes);
    std::vector<NodeId>& nodes = cracked.node_sets[s].nodes;
    const std::vector<bool> now = marked(cracked.node_count(), nodes);
    const auto member = [&](NodeId n) { return now[n.index()]; };
    for (std::size_t g = 0; g < gone.size(); ++g) {
      if (before[gone[g].index()] && !member(gone[g]) &&
          std::ranges::none_of(company[g].same_place, member)) {
        nodes.push_back(gone[g]);
        nodes.insert(nodes.end(), company[g].second.begin(), company[g].second.end());
      }
    }
  }
}

std::optional<NodeId> find_removed_held_node(const model::Model& model, const model::Mesh& cracked,
                                             std::string_view set) {
  const model::Mesh& host = model.mesh;
  const auto asked = std::ranges::find(host.node_sets, set, &model::NodeSet::name);
  if (asked == host.node_sets.end()) {
    return std::nullopt;
  }
  const std::vector<bool> inside = marked(host.node_count(), asked->nodes);
  std::vector<bool> held(host.node_count(), false);
  for (const model::NodeSetFreedomRole& freedom : model.freedoms) {
    if (model::is_suppressed_or_prescribed(freedom.cls)) {
      for (const NodeId n : host.set_with_id(freedom.nodes).nodes) {
        held[n.index()] = true;
      }
    }
  }
  std::vector<NodeId> removed = gone_nodes(host, cracked);
  std::erase_if(removed, [&](NodeId n) { return !inside[n.index()] || !held[n.index()]; });
  if (removed.empty()) {
    return std::nullopt;
  }
  const std::vector<bool> stands_in = marked(
      host.node_count(),
      mesh::nodes_of_faces(host, mesh::boundary_faces_with_all_nodes_in(host, asked->nodes)));
  const auto at = std::ranges::find_if(removed, [&](NodeId n) { return !stands_in[n.index()]; });
  return at == removed.end() ? std::nullopt : std::optional(*at);
}

} // namespace spricka::analysis
