// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/lengths/shown_results.hpp"

#include "analysis/scene/gone_nodes.hpp"
#include "fe/stress.hpp"
#include "mesh/boundary.hpp"
#include "model/model.hpp"
#include "shape/topology.hpp"

#include <algorithm>
#include <utility>

namespace spricka::analysis {

namespace {

std::vector<results::Stress> as_results(const std::vector<fe::Stress>& stress) {
  std::vector<results::Stress> out(stress.size());
  for (std::size_t n = 0; n < stress.size(); ++n) {
    std::copy_n(stress[n].data(), 6, out[n].begin());
  }
  return out;
}

} // namespace

std::vector<results::OuterSurfaceFace> outer_faces_by_nodes(const model::Mesh& mesh) {
  if (mesh.type.empty() || shape::is_plane_element_side(mesh.type.front(), 0)) {
    return {}; // plane elements show their own faces
  }
  std::vector<results::OuterSurfaceFace> surface;
  for (const model::Face& face : mesh::outer_surface_faces(mesh)) {
    const base::ElementType type = mesh.type[face.element.index()];
    const std::span<const int> side = shape::side_nodes(type, face.side);
    results::OuterSurfaceFace out;
    out.element = face.element;
    const std::size_t corners = shape::side_corner_count(type, face.side);
    const auto node = [&](std::size_t i) {
      return mesh.element_nodes(face.element)[static_cast<std::size_t>(side[i])];
    };
    for (std::size_t i = 0; i < corners; ++i) {
      out.outline.push_back(node(i));
      if (side.size() >= 2 * corners) {
        // Corners and middles in turn, round the face.
        out.outline.push_back(node(corners + i));
      }
    }
    surface.push_back(std::move(out));
  }
  return surface;
}

// Reports know nodes of sets but not of faces.
void add_face_sets_as_node_sets(const model::Model& model, model::Mesh& mesh) {
  for (const model::FaceSet& set : mesh.face_sets) {
    const bool wanted =
        std::ranges::any_of(model.outputs, [&](const model::OutputFileRequest& output) {
          return std::ranges::any_of(output.requests,
                                     [&](const auto& request) { return request.name == set.name; });
        });
    const bool there = std::ranges::any_of(
        mesh.node_sets, [&](const model::NodeSet& nodes) { return nodes.name == set.name; });
    if (wanted && !there && !set.name.empty()) {
      mesh.node_sets.push_back({set.name, mesh::nodes_of_faces(mesh, set.faces), set.span});
    }
  }
}

void add_stress_fields(const model::Model& model, const model::Mesh& mesh,
                       results::LoadStepResult& step) {
  const fe::DisplacementTemperatureField field{step.u, step.temperature};
  std::vector<fe::Stress> nodal =
      fe::nodal_stress(model, mesh, fe::element_node_stress(model, mesh, field));
  fill_removed_node_stresses(model, mesh, field, nodal);
  step.stress = as_results(nodal);
  step.element_stress = as_results(fe::element_mean_stress(model, mesh, field));
}

void add_shown_results(const model::Model& model, Discretisation& scene,
                       results::CrackLengthResult& increment) {
  increment.kept = static_cast<std::size_t>(
      std::ranges::count_if(scene.cracked.host, [](base::ElementId e) { return e.valid(); }));
  increment.mesh = std::move(scene.cracked.mesh);
  increment.surface = outer_faces_by_nodes(increment.mesh);
  const std::vector<RemovedNodePlace> gone = locate_removed_nodes(model.mesh, increment.mesh);
  for (results::LoadStepResult& step : increment.steps) {
    fill_removed_node_displacements(increment.mesh, gone, step.u);
  }
  keep_removed_set_members(model.mesh, increment.mesh);
  add_face_sets_as_node_sets(model, increment.mesh);
}

} // namespace spricka::analysis
