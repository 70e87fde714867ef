// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesher/answers.hpp"

#include "mesher/step_entities.hpp"

#include <gmsh.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace spricka::mesher {
namespace {

bool is_index(int i, std::size_t count) {
  return i >= 0 && static_cast<std::size_t>(i) < count;
}

/// gmsh's numbers of what a request names.
class StepEntities {
public:
  StepEntities() : volumes_(model_volumes()) {
    for (const int volume : volumes_) {
      faces_.push_back(faces_of_volume(volume));
    }
  }
  [[nodiscard]] const std::vector<int>& volumes() const { return volumes_; }
  [[nodiscard]] bool has(const mesh::StepMeshGroup& group) const {
    return (group.solid < 0 || is_index(group.solid, volumes_.size())) &&
           std::ranges::all_of(group.faces, [&](const std::array<int, 2>& face) {
             return is_index(face[0], volumes_.size()) &&
                    is_index(face[1], faces_[static_cast<std::size_t>(face[0])].size());
           });
  }
  [[nodiscard]] int volume(int solid) const { return volumes_[static_cast<std::size_t>(solid)]; }
  [[nodiscard]] std::vector<int> faces(const mesh::StepMeshGroup& group) const {
    std::vector<int> tags;
    for (const auto& [solid, face] : group.faces) {
      tags.push_back(faces_[static_cast<std::size_t>(solid)][static_cast<std::size_t>(face)]);
    }
    return tags;
  }

private:
  std::vector<int> volumes_;
  std::vector<std::vector<int>> faces_; ///< [volume]
};

/// The sizes that groups ask for on their faces and, growing, round them.
mesh::SolidGrading sizes_at_faces(const StepEntities& entities,
                                  const mesh::StepMeshRequest& request) {
  mesh::SolidGrading grading;
  for (const mesh::StepMeshGroup& group : request.groups) {
    if (group.size <= 0.0) {
      continue;
    }
    for (const int face : entities.faces(group)) {
      FacePoints of_face = points_inside_face(face, group.size);
      const std::vector<base::Vec3> of_edges = points_of_face_edges(face);
      of_face.points.insert(of_face.points.end(), of_edges.begin(), of_edges.end());
      for (const base::Vec3& x : of_face.points) {
        grading.add_size_source({.at = x, .size = group.size, .radius = of_face.apart});
      }
    }
  }
  return grading;
}

void set_sizes(const StepEntities& entities, const mesh::StepMeshRequest& request) {
  double smallest = request.size * mesh::StepMeshRequest::smallest_part;
  for (const mesh::StepMeshGroup& group : request.groups) {
    smallest = group.size > 0.0 ? std::min(smallest, group.size) : smallest;
  }
  gmsh::option::setNumber("Mesh.MeshSizeMax", request.size);
  gmsh::option::setNumber("Mesh.MeshSizeMin", smallest);
  gmsh::option::setNumber("Mesh.MeshSizeFromCurvature",
                          std::round(mesh::StepMeshRequest::elements_in_a_turn * request.finer));
  gmsh::option::setNumber("Mesh.HighOrderOptimize", 1); // where a curved edge turns one inside out
  const mesh::SolidGrading grading = sizes_at_faces(entities, request);
  if (!grading.sources().empty()) {
    gmsh::model::mesh::setSizeCallback(
        [grading, size = request.size](int, int, double x, double y, double z) {
          return std::min(size, grading(base::Vec3(x, y, z)));
        });
  }
}

} // namespace

bool prepare_step_mesh(const mesh::StepMeshRequest& request) {
  const StepEntities entities;
  const auto known = [&](int solid) { return is_index(solid, entities.volumes().size()); };
  if (request.solids.empty() || !std::ranges::all_of(request.solids, known) ||
      !std::ranges::all_of(request.groups,
                           [&](const auto& group) { return entities.has(group); })) {
    return false;
  }
  for (const mesh::StepMeshGroup& group : request.groups) {
    const bool of_faces = group.solid < 0;
    const std::vector<int> members =
        of_faces ? entities.faces(group) : std::vector<int>{entities.volume(group.solid)};
    const int dimension = of_faces ? 2 : 3;
    gmsh::model::setPhysicalName(dimension, gmsh::model::addPhysicalGroup(dimension, members),
                                 group.name);
  }
  set_sizes(entities, request);
  gmsh::vectorpair others;
  for (std::size_t i = 0; i < entities.volumes().size(); ++i) {
    if (std::ranges::find(request.solids, static_cast<int>(i)) == request.solids.end()) {
      others.emplace_back(3, entities.volumes()[i]);
    }
  }
  if (!others.empty()) {
    gmsh::model::removeEntities(others, true);
  }
  return true;
}

} // namespace spricka::mesher
