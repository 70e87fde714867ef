// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/scene/scene_nodes.hpp"

#include "mesh/cut/crack_face_sets.hpp"
#include "model/model.hpp"

#include <algorithm>

#include <fmt/format.h>

namespace spricka::analysis {

namespace {

constexpr const char* smaller_patch = "keep the crack's patch away from it: a smaller RADIUS on "
                                      "$TIPNET, or use TRACTION or RESULTANT "
                                      "on a face set";

bool is_nothing(const model::Load& load) {
  return std::ranges::all_of(load.value, [](const base::CompiledExpression& v) {
    return v.is_constant() && v(base::Vec3::Zero()) == 0.0;
  });
}

std::vector<base::NodeId> sorted(std::vector<base::NodeId> nodes) {
  std::ranges::sort(nodes);
  nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
  return nodes;
}

// Each node of the set carries the force: nodes that go or come change the sum. The node of a
// crack's mouth may be that of the other face.
std::string changed(const model::Model& model, const Discretisation& scene,
                    const model::Load& load) {
  const model::Mesh& mesh = scene.cracked.mesh;
  const mesh::NodeSetsOnCrackFaces crack_faces(mesh, scene.cracked.faces);
  const std::vector<base::NodeId> before = sorted(model.mesh.set_with_id(load.nodes).nodes);
  const std::vector<base::NodeId> now = sorted(mesh.set_with_id(load.nodes).nodes);
  for (const base::NodeId n : before) {
    const auto stays = [&](base::NodeId m) { return std::ranges::binary_search(now, m); };
    if (!stays(n) && std::ranges::none_of(crack_faces.coincident_nodes(n), stays)) {
      return fmt::format("a crack has cut out node {}, which it loads", mesh.node_label[n.index()]);
    }
  }
  return now.size() > before.size()
             ? fmt::format("a crack has added {} nodes to those that it loads, each of which would "
                           "carry the force again",
                           now.size() - before.size())
             : "";
}

} // namespace

bool check_force_nodes(const model::Model& model, const Discretisation& scene,
                       base::Diagnostics& diagnostics) {
  const model::Mesh& mesh = scene.cracked.mesh;
  std::vector<bool> taken = model::mark_nodes_in_use(mesh);
  for (const fe::ConstraintTransformation::DependentRow& row : scene.ties->rows()) {
    taken[static_cast<std::size_t>(row.freedom / mesh.dim)] = true;
    for (const fe::FreedomTerm& t : row.terms) {
      taken[static_cast<std::size_t>(t.freedom / mesh.dim)] = true;
    }
  }
  for (const model::LoadCase& load_case : model.cases) {
    for (const model::Load& load : load_case.loads) {
      if (load.type != model::LoadType::force || is_nothing(load)) {
        continue;
      }
      if (const std::string why = changed(model, scene, load); !why.empty()) {
        diagnostics.error(load.span, "E418", fmt::format("load case {}: {}", load_case.name, why),
                          smaller_patch);
        return false;
      }
      for (const base::NodeId n : mesh.set_with_id(load.nodes).nodes) {
        if (!taken[n.index()]) {
          diagnostics.error(load.span, "E418",
                            fmt::format("load case {}: no element has node {}, which it loads",
                                        load_case.name, mesh.node_label[n.index()]),
                            "tie the node by $MPC, or load one of the body");
          return false;
        }
      }
    }
  }
  return true;
}

bool check_supports_survive_cut(const model::Model& model, const Discretisation& scene,
                                base::Diagnostics& diagnostics) {
  const auto keeps = [&](base::NodeSetId nodes, const base::SourceSpan& span, const char* what) {
    const std::size_t set = nodes.index();
    if (set >= scene.cracked.unreplaced_set_nodes.size() ||
        scene.cracked.unreplaced_set_nodes[set].empty()) {
      return true;
    }
    const base::NodeId n = scene.cracked.unreplaced_set_nodes[set].front();
    diagnostics.error(span, "E419",
                      fmt::format("a crack has cut out node {}, which is {} here",
                                  model.mesh.node_label[n.index()], what),
                      "keep the crack's patch away from it: a smaller RADIUS on $TIPNET");
    return false;
  };
  for (const model::NodeSetFreedomRole& freedom : model.freedoms) {
    if (model::is_suppressed_or_prescribed(freedom.cls) &&
        !keeps(freedom.nodes, freedom.span, "held")) {
      return false;
    }
  }
  for (const model::LoadCase& load_case : model.cases) {
    for (const model::Load& load : load_case.loads) {
      if (load.type == model::LoadType::displacement && !keeps(load.nodes, load.span, "moved")) {
        return false;
      }
    }
  }
  return true;
}

} // namespace spricka::analysis
