// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "mesh/surface/surface_geometry.hpp"

#include <optional>
#include <vector>

namespace spricka::mesh {

/// The surface of one body of a mesh, other bodies left out. Borders of all face sets are edges of
/// it, so that what is meshed anew belongs to the same sets.
class BodySurface {
public:
  BodySurface(const model::Mesh& mesh, const std::vector<base::ElementId>& elements);

  [[nodiscard]] const SurfaceGeometry& geometry() const { return *geometry_; }
  /// The number of a face of the mesh in the geometry; `nowhere` if it is none of its surface.
  [[nodiscard]] std::size_t index(const model::Face& face) const;
  /// The face of the mesh with a number of the geometry.
  [[nodiscard]] model::Face face(std::size_t index) const;

private:
  std::vector<base::ElementId> elements_; ///< [number in the geometry]
  std::vector<std::int32_t> number_;      ///< [element] or -1
  std::optional<SurfaceGeometry> geometry_;
};

} // namespace spricka::mesh
