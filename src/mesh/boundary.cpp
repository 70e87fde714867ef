// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/boundary.hpp"

#include "mesh/side_index.hpp"
#include "model/mesh_side.hpp"
#include "shape/topology.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <utility>

namespace spricka::mesh {
namespace {

/// Triangles that lie on the other side of quadrilaterals of a mesh of solids.
class FacesThatMeet {
public:
  FacesThatMeet(const model::Mesh& mesh, const SideIndex& sides,
                const std::vector<model::Face>& alone)
      : mesh_(mesh), sides_(sides) {
    for (const model::Face& face : alone) {
      const std::vector<base::NodeId> corners = corners_of(face);
      for (std::size_t i = 0; i < 3 && corners.size() == 3; ++i) {
        opposite_.emplace(std::minmax(corners[i], corners[(i + 1) % 3]), corners[(i + 2) % 3]);
      }
    }
  }

  /// Two on a diagonal of it, or four round a node in it; empty if it is no quadrilateral or meets
  /// none.
  [[nodiscard]] std::vector<model::Face> triangles_of(const model::Face& face) const {
    const std::vector<base::NodeId> c = corners_of(face);
    if (c.size() != 4) {
      return {};
    }
    std::vector<model::Face> found = find({{c[0], c[1], c[2]}, {c[0], c[2], c[3]}});
    if (found.empty()) {
      found = find({{c[1], c[2], c[3]}, {c[1], c[3], c[0]}});
    }
    const auto [begin, end] = opposite_.equal_range(std::minmax(c[0], c[1]));
    for (auto at = begin; at != end && found.empty(); ++at) {
      const base::NodeId m = at->second;
      found = find({{c[0], c[1], m}, {c[1], c[2], m}, {c[2], c[3], m}, {c[3], c[0], m}});
    }
    return found;
  }

private:
  using Corners = std::array<base::NodeId, 3>;

  [[nodiscard]] std::vector<base::NodeId> corners_of(const model::Face& face) const {
    FaceNodes nodes = face_nodes(mesh_, face);
    nodes.all.resize(nodes.corners);
    return nodes.all;
  }

  /// The sides with these corners, if all are there and none has an element behind it.
  [[nodiscard]] std::vector<model::Face> find(const std::vector<Corners>& triangles) const {
    std::vector<model::Face> found;
    for (const Corners& corners : triangles) {
      const auto side = sides_.find(corners);
      if (side.size() != 1) {
        return {};
      }
      found.push_back(side.front());
    }
    return found;
  }

  const model::Mesh& mesh_;
  const SideIndex& sides_;
  std::multimap<std::pair<base::NodeId, base::NodeId>, base::NodeId> opposite_; ///< [edge]
};

} // namespace

std::vector<model::Face> boundary_faces(const model::Mesh& mesh) {
  return SideIndex(mesh).unshared_sides();
}

std::vector<model::Face> outer_surface_faces(const model::Mesh& mesh) {
  const SideIndex sides(mesh);
  std::vector<model::Face> faces = sides.unshared_sides();
  const auto is_quadrilateral = [&](const model::Face& face) {
    return shape::side_corner_count(mesh.type[face.element.index()], face.side) == 4;
  };
  if (std::ranges::none_of(faces, is_quadrilateral)) {
    return faces;
  }
  const FacesThatMeet meet(mesh, sides, faces);
  std::vector<model::Face> met;
  for (const model::Face& face : faces) {
    const std::vector<model::Face> triangles = meet.triangles_of(face);
    if (!triangles.empty()) {
      met.push_back(face);
      met.insert(met.end(), triangles.begin(), triangles.end());
    }
  }
  std::ranges::sort(met);
  std::erase_if(faces, [&](const model::Face& f) { return std::ranges::binary_search(met, f); });
  return faces;
}

std::vector<model::Face> boundary_faces_with_all_nodes_in(const model::Mesh& mesh,
                                                          const std::vector<base::NodeId>& nodes) {
  if (nodes.empty()) {
    return {};
  }
  const std::vector<bool> inside = model::mark_members(mesh.node_count(), nodes);
  // Sides on both sides of a face have the same corners: only those of these nodes are compared.
  std::vector<model::Face> result = SideIndex(mesh, 0, &inside).unshared_sides();
  std::erase_if(result, [&](const model::Face& face) {
    return !face_has_all_nodes_inside(mesh, face, inside);
  });
  return result;
}

FaceNodes face_nodes(const model::Mesh& mesh, const model::Face& face) {
  return {model::side_nodes(mesh, face),
          shape::side_corner_count(mesh.type[face.element.index()], face.side)};
}

bool face_has_all_nodes_inside(const model::Mesh& mesh, const model::Face& face,
                               const std::vector<bool>& inside) {
  return std::ranges::all_of(face_nodes(mesh, face).all,
                             [&](base::NodeId n) { return inside[n.index()]; });
}

std::vector<base::NodeId> nodes_of_faces(const model::Mesh& mesh,
                                         const std::vector<model::Face>& faces) {
  std::vector<base::NodeId> result;
  for (const model::Face& face : faces) {
    const FaceNodes nodes = face_nodes(mesh, face);
    result.insert(result.end(), nodes.all.begin(), nodes.all.end());
  }
  std::sort(result.begin(), result.end());
  result.erase(std::unique(result.begin(), result.end()), result.end());
  return result;
}

std::vector<FaceChain> build_face_chains(const model::Mesh& mesh,
                                         const std::vector<model::Face>& faces) {
  std::multimap<base::NodeId, std::size_t> leaving; // equal keys keep the order of insertion
  std::map<base::NodeId, int> surplus;              // edges that leave minus edges that arrive
  std::vector<std::pair<base::NodeId, base::NodeId>> ends;
  for (std::size_t i = 0; i < faces.size(); ++i) {
    const auto [a, b] = ends.emplace_back(face_nodes(mesh, faces[i]).edge(0));
    leaving.emplace(a, i);
    ++surplus[a];
    --surplus[b];
  }
  std::vector<bool> used(faces.size(), false);
  std::vector<FaceChain> result;
  const auto walk = [&](std::size_t start) {
    FaceChain chain;
    const base::NodeId first = ends[start].first;
    std::size_t at = start;
    for (bool more = true; more;) {
      used[at] = true;
      chain.faces.push_back(faces[at]);
      const base::NodeId end = ends[at].second;
      chain.closed = end == first;
      more = false;
      const auto [begin, stop] = leaving.equal_range(end);
      for (auto it = begin; it != stop && !chain.closed && !more; ++it) {
        if (!used[it->second]) {
          at = it->second;
          more = true;
        }
      }
    }
    result.push_back(std::move(chain));
  };
  for (std::size_t i = 0; i < faces.size(); ++i) { // open chains from their ends
    int& left = surplus[ends[i].first];
    if (!used[i] && left > 0) {
      --left;
      walk(i);
    }
  }
  for (std::size_t i = 0; i < faces.size(); ++i) {
    if (!used[i]) {
      walk(i);
    }
  }
  return result;
}

} // namespace spricka::mesh
