// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "contact/space/clip.hpp"
#include "contact/space/pair_point.hpp"
#include "geometry/box_tree.hpp"

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

/// What the triangles of one surface see of another along their normals, as points to integrate
/// over.
namespace spricka::contact {

/// A target made ready to be looked for.
class SurfaceProjector {
public:
  /// Both must outlive this. What lies farther off than a fifth of the extent of `contact` is not
  /// opposite; `farther` [length] adds to that.
  SurfaceProjector(const FacetSurface& contact, const FacetSurface& target, double farther = 0.0);

  /// What a triangle between nodes of a face of the contact surface sees: triangles of the target
  /// that look the other way, projected onto its plane and clipped; a degree 5 rule on each piece,
  /// its points on the curved faces; the target is met along the contact surface's normal.
  [[nodiscard]] OppositePointsOfElement project_triangle(const HatElement& triangle) const;
  /// Whether one of some faces of the target [face] lies opposite a triangle, seen as flat ones.
  [[nodiscard]] bool faces_any_of(const HatElement& triangle, const std::vector<bool>& faces) const;
  /// The target's nearest point on the line through x along the unit vector n, which leaves the
  /// contact surface; only target, s, gap, turn, x and normal are given.
  [[nodiscard]] std::optional<PairPoint> project_along_normal(const Vec3& x, const Vec3& n) const;
  /// The same with the face first that a point beside it, or the same one before, has met.
  [[nodiscard]] std::optional<PairPoint>
  project_along_normal(const Vec3& x, const Vec3& n, const PairQuadraturePoint& neighbour) const;

private:
  struct Frame;
  /// Where a line meets the plane of a triangle of the target.
  struct TriangleOnLine {
    std::size_t triangle = 0;
    Eigen::Vector3d share; ///< of the corners; one below 0: beside the triangle
    double gap = 0.0;      ///< along the line [length]
  };
  /// A triangle of the target on the plane of one of the contact surface.
  struct FlatView {
    PlaneTriangle flat;
    std::vector<Vec2> seen; ///< the polygon that both have in common
  };
  [[nodiscard]] geometry::Box<3> prism(const Frame& frame) const;
  /// Nothing: it is too far off, or looks another way.
  [[nodiscard]] std::optional<FlatView> project_flat(const Frame& frame, std::size_t target) const;
  void see_target(const Frame& frame, std::size_t target,
                  OppositePointsOfElement& projection) const;
  [[nodiscard]] bool meet(std::size_t face, PairPoint& point) const;
  /// The point of a face on the line through x along n, sought from s on; none beside the face.
  [[nodiscard]] std::optional<PairPoint> meet_face(const Vec3& x, const Vec3& n, std::size_t face,
                                                   const Vec2& s) const;
  [[nodiscard]] std::optional<TriangleOnLine> meet_plane_of(std::size_t triangle, const Vec3& x,
                                                            const Vec3& n) const;
  /// look(), no farther than `far` either way.
  [[nodiscard]] std::optional<PairPoint> look_as_far(const Vec3& x, const Vec3& n,
                                                     double far) const;

  const FacetSurface& contact_;
  const FacetSurface& target_;
  double reach_ = 0.0;
  double size_ = 0.0;                       ///< of the target's triangles, on average
  geometry::BoxTree<3> tree_;               ///< of the target's triangles
  std::vector<std::array<Vec3, 3>> corner_; ///< [triangle of the target]
};

} // namespace spricka::contact
