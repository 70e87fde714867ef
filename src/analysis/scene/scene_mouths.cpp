// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/scene/scene_mouths.hpp"

#include "mesh/cut/crack_face_sets.hpp"
#include "mesh/cut/host.hpp"
#include "model/model.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace spricka::analysis {

namespace {

using model::FreedomRole;

/// Finds cards that name a doubled node without a side that tells its face.
class Mouths {
public:
  Mouths(const model::Model& model, const Discretisation& scene, base::Diagnostics& diagnostics)
      : model_(model), scene_(scene), diagnostics_(diagnostics),
        membership_(scene.cracked.mesh, scene.cracked.faces) {}

  void set(base::NodeSetId id, const base::SourceSpan& span, const char* what) {
    for (const auto& choice :
         membership_.choose_nodes_belonging_to_set(scene_.cracked.mesh.set_with_id(id).nodes)) {
      if (choice.alone) {
        report(choice.nodes, span, what);
        return;
      }
    }
  }

  void node(base::NodeId n, const base::SourceSpan& span, const char* what) {
    if (const auto nodes = membership_.coincident_nodes(n); !nodes.empty()) {
      report(nodes, span, what);
    }
  }

  [[nodiscard]] bool good() const { return good_; }

private:
  [[nodiscard]] std::string crack_at(base::NodeId n) const {
    for (std::size_t i = 0; i < scene_.cracked.faces.size(); ++i) {
      if (std::ranges::find(scene_.cracked.faces[i].left, n) !=
          scene_.cracked.faces[i].left.end()) {
        return model_.cracks[i].name;
      }
    }
    return {};
  }

  void report(std::span<const base::NodeId> nodes, const base::SourceSpan& span, const char* what) {
    const base::Vec3& x = scene_.cracked.mesh.x[nodes.front().index()];
    diagnostics_.error(span, "E437",
                       fmt::format("crack {} opens at ({:.6g}, {:.6g}), in a node that is {} here: "
                                   "nothing tells which of its faces is meant",
                                   crack_at(nodes.front()), x.x(), x.y(), what),
                       "name a set with an edge that ends there (its side of the crack is meant), "
                       "or move the crack a little to one side");
    good_ = false;
  }

  const model::Model& model_;
  const Discretisation& scene_;
  base::Diagnostics& diagnostics_;
  mesh::NodeSetsOnCrackFaces membership_;
  bool good_ = true;
};

std::vector<bool> marked(const model::Mesh& mesh, const std::vector<base::NodeId>& nodes) {
  std::vector<bool> in(mesh.node_count(), false);
  for (const base::NodeId n : nodes) {
    in[n.index()] = true;
  }
  return in;
}

/// Sides at the nodes of a crack face that lead away from its line.
std::vector<mesh::EdgeEndAndMidNodes> sides_off(const model::Mesh& mesh,
                                                const std::vector<base::NodeId>& crack_face,
                                                std::size_t across) {
  const std::vector<bool> on_crack_face = marked(mesh, crack_face);
  const auto a = static_cast<Eigen::Index>(across);
  const base::Vec3& start = mesh.x[crack_face.front().index()];
  // Of the length of the crack.
  const double near = 1e-9 * (mesh.x[crack_face.back().index()] - start).norm();
  const auto on_line = [&](base::NodeId n) {
    return std::abs(mesh.x[n.index()][a] - start[a]) <= near;
  };
  std::vector<mesh::EdgeEndAndMidNodes> sides;
  for (std::size_t e = 0; e < mesh.element_count(); ++e) {
    const base::ElementId element(e);
    if (std::ranges::none_of(mesh.element_nodes(element),
                             [&](base::NodeId n) { return on_crack_face[n.index()]; })) {
      continue;
    }
    for (int s = 0; s < base::element_info(mesh.type[e]).sides; ++s) {
      const mesh::EdgeEndAndMidNodes edge = mesh::element_edge_nodes(mesh, {element, s});
      // One end on the face, the other off the line: a side that a support may hold for reasons of
      // its own.
      if (on_crack_face[edge.a.index()] != on_crack_face[edge.b.index()] &&
          !(on_line(edge.a) && on_line(edge.b))) {
        sides.push_back(edge);
      }
    }
  }
  return sides;
}

/// Nodes of a crack face that some support holds across it by a side beside the line.
std::vector<bool> held_beside(const model::Model& model, const model::Mesh& mesh,
                              const std::vector<base::NodeId>& crack_face, std::size_t across) {
  std::vector<bool> held(mesh.node_count(), false);
  const std::vector<mesh::EdgeEndAndMidNodes> sides = sides_off(mesh, crack_face, across);
  for (const model::NodeSetFreedomRole& freedom : model.freedoms) {
    if (freedom.cls != FreedomRole::suppressed || !freedom.dof[across]) {
      continue;
    }
    const std::vector<bool> in = marked(mesh, mesh.set_with_id(freedom.nodes).nodes);
    for (const mesh::EdgeEndAndMidNodes& side : sides) {
      if (in[side.a.index()] && in[side.b.index()]) {
        held[side.a.index()] = held[side.b.index()] = true;
      }
    }
  }
  return held;
}

} // namespace

bool check_nodes_split_by_crack(const model::Model& model, const Discretisation& scene,
                                base::Diagnostics& diagnostics) {
  Mouths mouths(model, scene, diagnostics);
  for (const model::NodeSetFreedomRole& freedom : model.freedoms) {
    if (model::is_suppressed_or_prescribed(freedom.cls)) {
      mouths.set(freedom.nodes, freedom.span, "held");
    }
  }
  for (const model::Mpc& mpc : model.mpcs) {
    if (const auto* equation = std::get_if<model::ConstraintEquation>(&mpc)) {
      for (const model::ConstraintEquation::ConstraintTerm& term : equation->terms) {
        mouths.node(term.node, equation->span, "tied");
      }
    } else if (const auto* transition = std::get_if<model::TransitionTie>(&mpc)) {
      mouths.set(transition->slave, transition->span, "tied");
    } else if (const auto* rigid = std::get_if<model::RigidTie>(&mpc)) {
      mouths.set(rigid->slave, rigid->span, "tied");
    }
  }
  for (const model::LoadCase& load_case : model.cases) {
    for (const model::Load& load : load_case.loads) {
      if (load.type == model::LoadType::force) {
        mouths.set(load.nodes, load.span, "loaded");
      }
    }
  }
  return mouths.good();
}

void free_symmetry_nodes_behind_tip(const model::Model& model,
                                    const std::vector<mesh::CrackLine>& lines,
                                    Discretisation& scene) {
  const model::Mesh& mesh = scene.cracked.mesh;
  const auto dim = static_cast<std::size_t>(mesh.dim);
  for (std::size_t i = 0; i < lines.size(); ++i) {
    if (!lines[i].symmetric_half) {
      continue;
    }
    const base::Vec3 along = (lines[i].points.back() - lines[i].points.front()).normalized();
    const std::size_t across = std::abs(along.x()) > std::abs(along.y()) ? 1 : 0;
    const mesh::CrackFaceNodes& crack_faces = scene.cracked.faces[i];
    const std::vector<base::NodeId>& crack_face = crack_faces.meshed_face_nodes();
    const std::vector<bool> held = held_beside(model, mesh, crack_face, across);
    // All but the tip, which stays on the line.
    for (std::size_t k = 0; k + 1 < crack_face.size(); ++k) {
      FreedomRole& c = scene.cls[dim * crack_face[k].index() + across];
      c = c == FreedomRole::suppressed && !held[crack_face[k].index()] ? FreedomRole::local : c;
    }
  }
}

bool check_loaded_crack_faces_exist(const model::Model& model, const Discretisation& scene,
                                    base::Diagnostics& diagnostics) {
  const model::Mesh& mesh = scene.cracked.mesh;
  bool good = true;
  for (const model::LoadCase& load_case : model.cases) {
    for (const model::Load& load : load_case.loads) {
      for (const model::CrackDefinition& crack : model.cracks) {
        const bool face =
            load.faces.valid() && (load.faces == crack.left || load.faces == crack.right);
        if (!face || !mesh.set_with_id(load.faces).faces.empty()) {
          continue;
        }
        // TYPE=FACES, which names the crack, means all that there is
        const bool both = std::ranges::any_of(load_case.loads, [&](const model::Load& other) {
          return other.span.file == load.span.file && other.span.begin == load.span.begin &&
                 other.faces.valid() && !mesh.set_with_id(other.faces).faces.empty();
        });
        if (both) {
          continue;
        }
        const char* there = load.faces == crack.left ? "RIGHT" : "LEFT";
        diagnostics.error(
            load.span, "E438",
            fmt::format("load case {}: crack {} lies on a symmetry line, where the "
                        "body has its face {}.{} only",
                        load_case.name, crack.name, crack.name, there),
            fmt::format("load {}.{} alone: the mirror image carries the same", crack.name, there));
        good = false;
      }
    }
  }
  return good;
}

} // namespace spricka::analysis
