// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "model/mesh.hpp"

#include <optional>
#include <span>

namespace spricka::mesh {

/// The element with the worst value of a measure, and its centroid.
struct WorstElement {
  base::ElementId element;
  double value = 0.0;
  base::Vec3 at = base::Vec3::Zero();
};

/// Shape of plane elements. Scaled Jacobian: det J over the lengths of its columns, 1 for squares
/// and equilateral triangles, smallest over integration points (Knupp 2003). Aspect and angles take
/// edges as straight between corners.
struct MeshQuality {
  WorstElement scaled_jacobian; ///< smallest
  WorstElement aspect;          ///< largest of longest over shortest edge
  WorstElement smallest_angle;  ///< [rad]
  WorstElement largest_angle;   ///< [rad]
};

/// Empty without plane elements.
std::optional<MeshQuality> measure_quality(const model::Mesh& mesh,
                                           std::span<const base::ElementId> elements);

} // namespace spricka::mesh
