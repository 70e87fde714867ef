// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/scene/moved_borders.hpp"

#include "mesh/cut/host.hpp"
#include "model/model.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>

#include <fmt/format.h>

namespace spricka::analysis {

namespace {

using base::Vec3;

struct Border {
  Vec3 x;
  double edge = 0.0; ///< length of the edge that ends there
};

// Ends of a set of edges: nodes of one of them only.
std::vector<Border> borders_of(const model::Mesh& mesh, const model::FaceSet& set) {
  std::map<base::NodeId, std::pair<int, double>> met; // how often, and the edge's length
  for (const model::Face& face : set.faces) {
    const mesh::EdgeEndAndMidNodes edge = mesh::element_edge_nodes(mesh, face);
    const double length = (mesh.x[edge.b.index()] - mesh.x[edge.a.index()]).norm();
    for (const base::NodeId n : {edge.a, edge.b}) {
      ++met[n].first;
      met[n].second = length;
    }
  }
  std::vector<Border> borders;
  for (const auto& [node, times] : met) {
    if (times.first == 1) {
      borders.push_back({mesh.x[node.index()], times.second});
    }
  }
  return borders;
}

std::set<base::FaceSetId> sets_that_act(const model::Model& model) {
  std::set<base::FaceSetId> sets;
  for (const model::Contact& contact : model.contacts) {
    sets.insert({contact.slave, contact.master});
  }
  for (const model::LoadCase& load_case : model.cases) {
    for (const model::Load& load : load_case.loads) {
      sets.insert(load.faces);
    }
  }
  std::erase_if(sets, [](base::FaceSetId id) { return !id.valid(); });
  return sets;
}

} // namespace

void warn_of_moved_borders(const model::Model& model, const mesh::CrackedMesh& cracked,
                           base::Diagnostics& diagnostics) {
  constexpr double same_place = 1e-6; // of an edge
  if (std::ranges::none_of(cracked.fronts, &mesh::CrackFront::symmetric_half)) {
    return; // elsewhere the boundary keeps its nodes
  }
  for (const base::FaceSetId id : sets_that_act(model)) {
    const model::FaceSet& old = model.mesh.set_with_id(id);
    const std::vector<Border> ends = borders_of(cracked.mesh, cracked.mesh.set_with_id(id));
    for (const Border& border : borders_of(model.mesh, old)) {
      double moved = std::numeric_limits<double>::infinity();
      for (const Border& end : ends) {
        moved = std::min(moved, (end.x - border.x).norm());
      }
      if (std::isfinite(moved) && moved > same_place * border.edge) {
        diagnostics.warning(
            model.cracks[cracked.fronts.front().crack.index()].span, "W425",
            fmt::format("the patch of a crack divides the line of symmetry anew: the border of {} "
                        "at ({:.6g}, {:.6g}) moves by {:.3g}",
                        old.name.empty() ? "a set" : "the set " + old.name, border.x.x(),
                        border.x.y(), moved),
            "what is loaded or in contact there is another part of the line; PATCH=NO on $TIPNET "
            "keeps a mesh that has the crack's tip");
      }
    }
  }
}

} // namespace spricka::analysis
