// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "mesh/surface/surface_geometry.hpp"

#include <optional>
#include <string>
#include <vector>

namespace spricka::mesh {

/// The surface of one body of a mesh, other bodies left out. Borders of all face sets, and of what
/// node sets have of the surface in whole faces, are edges of it, so that what is meshed anew
/// belongs to the same sets.
class BodySurface {
public:
  BodySurface(const model::Mesh& mesh, const std::vector<base::ElementId>& elements);

  [[nodiscard]] const SurfaceGeometry& geometry() const { return *geometry_; }
  /// The same faces and sets, only sharp edges: where a crack leaves no room for the borders of
  /// sets. Made when first asked for, by one thread at a time.
  [[nodiscard]] const SurfaceGeometry& without_borders() const;
  /// Names of the sets of the geometries; empty for those of single cards.
  [[nodiscard]] const std::string& set_name(std::size_t set) const {
    return body_.face_sets[set].name;
  }
  /// The number of a face of the mesh in the geometry; `nowhere` if it is none of its surface.
  [[nodiscard]] std::size_t index(const model::Face& face) const;
  /// The face of the mesh with a number of the geometry.
  [[nodiscard]] model::Face face(std::size_t index) const;

private:
  void add_face_sets(const model::Mesh& mesh);
  void add_node_sets(const model::Mesh& mesh);
  std::vector<base::ElementId> elements_; ///< [number in the geometry]
  std::vector<std::int32_t> number_;      ///< [element] or -1
  model::Mesh body_;                      ///< with face sets for all sets
  std::vector<base::FaceSetId> kept_;
  std::optional<SurfaceGeometry> geometry_;
  mutable std::optional<SurfaceGeometry> without_borders_;
};

} // namespace spricka::mesh
