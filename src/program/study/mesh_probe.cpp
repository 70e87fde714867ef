// SPDX-License-Identifier: GPL-3.0-or-later
#include "program/study/mesh_probe.hpp"

#include "base/vec.hpp"

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

namespace spricka::program {

namespace {

/// How much a mesh has of everything: to see whether only its sizes have changed.
struct ProbedMeshExtent {
  std::size_t elements = 0;
  std::vector<std::pair<std::string, std::pair<base::Vec3, base::Vec3>>> sets; ///< low, high
};

void widen(std::pair<base::Vec3, base::Vec3>& box, const base::Vec3& x) {
  box.first = box.first.cwiseMin(x);
  box.second = box.second.cwiseMax(x);
}

ProbedMeshExtent extent_of(const model::Mesh& mesh) {
  ProbedMeshExtent extent;
  extent.elements = mesh.element_count();
  const base::Vec3 far = base::Vec3::Constant(1e300);
  for (const model::ElementSet& set : mesh.element_sets) {
    std::pair<base::Vec3, base::Vec3> box{far, -far};
    for (const base::ElementId e : set.elements) {
      for (const base::NodeId n : mesh.element_nodes(e)) {
        widen(box, mesh.x[n.index()]);
      }
    }
    extent.sets.emplace_back(set.name, box);
  }
  for (const model::FaceSet& set : mesh.face_sets) {
    std::pair<base::Vec3, base::Vec3> box{far, -far};
    for (const model::Face& face : set.faces) {
      for (const base::NodeId n : mesh.element_nodes(face.element)) {
        widen(box, mesh.x[n.index()]);
      }
    }
    extent.sets.emplace_back(set.name, box);
  }
  return extent;
}

// Of faces whole elements are measured, whose depth changes with their size.
bool is_same_shape(const ProbedMeshExtent& a, const ProbedMeshExtent& b) {
  constexpr double moved = 0.15; // of the set's size
  if (a.sets.size() != b.sets.size()) {
    return false;
  }
  for (std::size_t i = 0; i < a.sets.size(); ++i) {
    const auto& [low, high] = a.sets[i].second;
    const double size = (high - low).norm();
    const double change = std::max((low - b.sets[i].second.first).cwiseAbs().maxCoeff(),
                                   (high - b.sets[i].second.second).cwiseAbs().maxCoeff());
    if (a.sets[i].first != b.sets[i].first || change > moved * size) {
      return false;
    }
  }
  return true;
}

} // namespace

std::optional<double> element_count_ratio(const model::Mesh& before, const model::Mesh& after) {
  constexpr double more = 1.15; // elements, or as many fewer
  const ProbedMeshExtent a = extent_of(before);
  const ProbedMeshExtent b = extent_of(after);
  const double ratio =
      static_cast<double>(b.elements) / static_cast<double>(std::max<std::size_t>(a.elements, 1));
  const bool changed = ratio > more || ratio < 1.0 / more;
  return changed && is_same_shape(a, b) ? std::optional(ratio) : std::nullopt;
}

} // namespace spricka::program
