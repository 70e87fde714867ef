// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "contact/space/face_triangles.hpp"
#include "contact/space/round.hpp"
#include "model/mesh.hpp"

#include <cstddef>
#include <optional>
#include <vector>

namespace spricka::contact {

/// A piece of a face between three of its nodes, which hats of the pressure are linear on.
struct SurfaceTriangle {
  std::size_t face = 0;
  FaceTriangle node{}; ///< of the face
};

/// A surface of solids: its faces, the smooth parts they belong to and the shapes of these.
struct SpaceSurface {
  std::vector<geometry::ElementSide> faces;
  std::vector<std::size_t> part;                    ///< [face]
  std::vector<std::optional<AnalyticShape>> rounds; ///< [part]
  /// Face by face; all nodes are corners of some, or only the corners of faces.
  std::vector<SurfaceTriangle> triangles;
  double extent = 0.0;    ///< diagonal of the bounding box [length]
  double mean_size = 0.0; ///< root of the mean area of the faces [length]

  [[nodiscard]] const std::optional<AnalyticShape>& analytic_shape(std::size_t face) const {
    return rounds[part[face]];
  }
};

SpaceSurface make_space_surface(const model::Mesh& mesh, const std::vector<model::Face>& faces);

/// The triangles of a surface between corners only, face by face.
std::vector<SurfaceTriangle> corner_triangles(const SpaceSurface& surface);

/// Unit normal of the surface at a point x of a face, given what the face itself has there: that of
/// its shape where it has one.
Vec3 surface_normal(const SpaceSurface& surface, std::size_t face, const geometry::SidePoint& at);

} // namespace spricka::contact
