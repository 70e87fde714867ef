// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "geometry/box_tree.hpp"

#include <array>
#include <cstddef>
#include <optional>
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

/// The boundary of a body as flat facets, to ask whether points lie inside.
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
  struct FacetWithNormals {
    std::array<base::Vec3, 3> x;
    base::Vec3 normal;                     ///< unit, out of the body
    std::array<base::Vec3, 3> at_corner{}; ///< sums of the normals that meet there
    std::array<base::Vec3, 3> at_edge{};
    double rise = 0.0; ///< of a smooth boundary above the facet
  };
  /// What two facets have in common, of each its number and which of its ridges that is: in the
  /// plane a corner, in space an edge.
  using Ridge = std::array<std::pair<std::size_t, std::size_t>, 2>;

  void sum_at_corners(const std::vector<FlatBoundaryFacet>& facets);
  [[nodiscard]] std::vector<Ridge> ridges(const std::vector<FlatBoundaryFacet>& facets) const;
  void join(const std::vector<Ridge>& ridges);

  const FacetKind* kind_;
  std::vector<FacetWithNormals> facets_;
  Box<3> box_;
  BoxTree<3> tree_;
};

} // namespace spricka::geometry
