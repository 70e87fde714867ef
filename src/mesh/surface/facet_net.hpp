// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "mesh/surface/surface_geometry.hpp"

#include <array>
#include <map>
#include <span>
#include <utility>
#include <vector>

namespace spricka::mesh {

/// Faces divided into plane triangles by their own maps, which meet in the vertices of the edges
/// they share: linear faces into 1 or 2, quadratic ones into 16 or 32.
class FacetTriangulation {
public:
  static constexpr int divisions = 4; ///< of an edge of a quadratic face

  struct SurfaceFacet {
    std::size_t face = nowhere;
    std::array<int, 3> vertex{-1, -1, -1}; ///< round the outer normal
    std::array<base::Vec2, 3> r;           ///< on the face
  };
  /// A side of facets that is part of an edge of the surface, with its t at both vertices.
  struct FacetEdgeSegment {
    std::size_t edge = nowhere;
    std::array<double, 2> t{0.0, 0.0}; ///< at the lower vertex, at the higher
  };

  /// With so many times more divisions.
  FacetTriangulation(const SurfaceGeometry& surface, std::span<const std::size_t> faces,
                     int finer = 1);

  [[nodiscard]] const std::vector<base::Vec3>& vertices() const { return x_; } ///< [vertex]
  [[nodiscard]] const std::vector<SurfaceFacet>& facets() const { return facets_; }
  /// The places of the vertices of a facet.
  [[nodiscard]] std::array<base::Vec3, 3> corners(const SurfaceFacet& facet) const {
    const auto x = [&](std::size_t c) { return x_[static_cast<std::size_t>(facet.vertex[c])]; };
    return {x(0), x(1), x(2)};
  }
  /// The facets of the i-th face given: from first(i) up to first(i + 1).
  [[nodiscard]] std::size_t first_facet(std::size_t i) const { return first_[i]; }
  /// What lies between two vertices, if it is part of an edge.
  [[nodiscard]] const FacetEdgeSegment* edge_segment(int v, int w) const;

private:
  void add_face(const SurfaceGeometry& surface, std::size_t face);
  [[nodiscard]] int steps(const geometry::ElementSide& face) const; ///< along an edge
  int corner(const geometry::ElementSide& face, int i);
  int on_side(const SurfaceGeometry& surface, std::size_t face, int i, int k);

  int finer_ = 1;
  std::vector<base::Vec3> x_;
  std::vector<SurfaceFacet> facets_;
  std::vector<std::size_t> first_;
  std::map<base::NodeId, int> corner_;
  std::map<std::pair<std::size_t, int>, int> inner_; ///< edge and step from its first end
  std::map<std::pair<int, int>, FacetEdgeSegment> sides_;
};

} // namespace spricka::mesh
