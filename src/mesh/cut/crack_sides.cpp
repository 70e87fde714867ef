// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/cut/crack_sides.hpp"

#include "mesh/boundary.hpp"
#include "mesh/cut/host.hpp"

#include <algorithm>
#include <map>
#include <utility>

namespace spricka::mesh {
namespace {

using base::NodeId;

// Sides whose nodes follow one another along a crack face. Sides run with their body on the left:
// along the left crack face they go towards the tip, along the right crack face away from it.
std::vector<model::Face> along(const model::Mesh& mesh, const std::vector<NodeId>& crack_face,
                               bool left) {
  std::map<NodeId, std::size_t> place;
  for (std::size_t i = 0; i < crack_face.size(); ++i) {
    place.emplace(crack_face[i], i);
  }
  std::vector<std::pair<std::size_t, model::Face>> found;
  for (std::size_t e = 0; e < mesh.element_count(); ++e) {
    const base::ElementId element(e);
    if (std::ranges::count_if(mesh.element_nodes(element),
                              [&](NodeId n) { return place.contains(n); }) < 2) {
      continue;
    }
    for (int s = 0; s < base::element_info(mesh.type[e]).sides; ++s) {
      const ElementEdge edge = element_edge(mesh, {element, s});
      const auto from = place.find(left ? edge.a : edge.b);
      const auto to = place.find(left ? edge.b : edge.a);
      if (from == place.end() || to == place.end()) {
        continue;
      }
      // Both ends alone do not tell: the middle node must lie on the same face.
      const std::size_t step = edge.mid.valid() ? 2 : 1;
      if (to->second == from->second + step &&
          (step == 1 || crack_face[from->second + 1] == edge.mid)) {
        found.emplace_back(from->second, model::Face{element, s});
      }
    }
  }
  std::ranges::sort(found);
  std::vector<model::Face> faces;
  faces.reserve(found.size());
  for (const auto& [at, face] : found) {
    faces.push_back(face);
  }
  return faces;
}

} // namespace

CrackFaceSides crack_face_sides(const model::Mesh& mesh, const CrackFaces& crack_faces) {
  if (crack_faces.has_sides()) {
    return {crack_faces.left_sides, crack_faces.right_sides};
  }
  return {along(mesh, crack_faces.left, true), along(mesh, crack_faces.right, false)};
}

} // namespace spricka::mesh
