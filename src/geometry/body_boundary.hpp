// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "geometry/box_tree.hpp"

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace spricka::geometry {

/// A flat facet of the boundary of a body: in the plane (z = 0) a segment with the body on its
/// left, in space a triangle whose corners run anticlockwise seen from outside.
struct FlatBoundaryFacet {
  std::array<base::Vec3, 3> x{base::Vec3::Zero(), base::Vec3::Zero(), base::Vec3::Zero()};
  /// Numbers of the corners: facets that have some in common hang together there.
  std::array<std::size_t, 3> vertex{};
};

/// The nearest place of a boundary.
struct BoundaryDistance {
  double distance = 0.0; ///< negative inside the body [length]
  double facet = 0.0;    ///< how far the facets may leave the curved boundary there [length]
};

/// The boundary of a body as flat facets, to ask whether points lie inside. Few are asked for of
/// large boundaries: what a facet's surroundings tell is looked up when it is the nearest.
class BodyBoundary {
public:
  /// dim 2: segments, the third corner means nothing; dim 3: triangles.
  BodyBoundary(int dim, const std::vector<FlatBoundaryFacet>& facets);

  /// The nearest place no farther off than `reach` [length], if there is one. Inside and outside
  /// are told by the normals of all facets that meet there, each by its angle (Baerentzen and
  /// Aanaes 2005): one of them alone may be wrong before a sharp corner.
  [[nodiscard]] std::optional<BoundaryDistance> signed_distance(const base::Vec3& x,
                                                                double reach) const;
  [[nodiscard]] const Box<3>& box() const { return box_; } ///< z is 0 in the plane

private:
  struct FacetKind;
  /// A corner of a facet.
  struct FacetCorner {
    std::size_t facet = 0, corner = 0;
  };

  void collect_facets_at_vertices();
  [[nodiscard]] std::span<const FacetCorner> facets_at(std::size_t vertex) const;
  [[nodiscard]] base::Vec3 facet_normal(std::size_t f) const; ///< unit, out of the body
  [[nodiscard]] base::Vec3 corner_normal(std::size_t f, std::size_t corner) const;
  [[nodiscard]] base::Vec3 ridge_normal(std::size_t f, std::size_t ridge) const;
  /// The facets with ridge `ridge` of f, in the plane a corner and in space an edge, in the order
  /// of their numbers; f is among them.
  [[nodiscard]] std::vector<FacetCorner> facets_at_ridge(std::size_t f, std::size_t ridge) const;
  /// Those beside f across one of its ridges where the boundary is smooth, with the turn there.
  [[nodiscard]] std::vector<std::pair<std::size_t, double>> smooth_neighbours(std::size_t f) const;
  [[nodiscard]] double rise_towards_neighbours(std::size_t f) const;
  /// Of a smooth boundary above a facet.
  [[nodiscard]] double rise(std::size_t f) const;

  const FacetKind* kind_;
  std::vector<FlatBoundaryFacet> facets_;
  std::vector<std::size_t> first_;     ///< [vertex - lowest] into at_vertex_, and the end
  std::vector<FacetCorner> at_vertex_; ///< facets by their vertices, ascending
  std::size_t lowest_ = 0;             ///< vertex
  Box<3> box_;
  BoxTree<3> tree_;
};

} // namespace spricka::geometry
