// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "contact/space/space_surface.hpp"
#include "geometry/box_tree.hpp"

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

/// What the triangles of one surface see of another along their normals, as points to integrate
/// over: in space what contact/pair_points.hpp is in the plane.
namespace spricka::contact {

/// One integration point of a triangle.
struct ProjectionPoint {
  std::size_t target = 0;                        ///< face of the target that lies opposite
  Vec2 r = Vec2::Zero();                         ///< on the triangle's face
  Vec2 s = Vec2::Zero();                         ///< on the target's
  Eigen::Vector3d hat = Eigen::Vector3d::Zero(); ///< hats of the triangle's corners
  Vec3 x = Vec3::Zero();
  Vec3 normal = Vec3::Zero(); ///< unit, from the contact surface towards the target
  double turn = 0.0;          ///< cosine between this and the target's normal reversed
  double weight = 0.0;        ///< area that the point stands for
  double gap = 0.0;           ///< along the normal [length]
  /// The same where surfaces whose nodes lie on one of the shapes of round.hpp were that.
  double round_gap = 0.0;
};

struct ProjectedTriangle {
  std::vector<ProjectionPoint> points; ///< target face by target face
  /// Integrals of the three hats over all of the triangle, whether something lies opposite or not.
  Eigen::Vector3d whole = Eigen::Vector3d::Zero();
  double flat_area = 0.0;        ///< of the plane triangle between the corners
  double flat_seen = 0.0;        ///< of it, what is covered; more than all: covered twice
  double unprojected_area = 0.0; ///< area of points whose normal met no target though it should
};

/// A target made ready to be looked for.
class SurfaceProjection {
public:
  /// Both must outlive this. What lies farther off than a fifth of the extent of `contact` is not
  /// opposite; `farther` [length] adds to that.
  SurfaceProjection(const SpaceSurface& contact, const SpaceSurface& target, double farther = 0.0);

  /// What a triangle between nodes of a face of the contact surface sees: triangles of the target
  /// that look the other way, projected onto its plane and clipped; a degree 5 rule on each piece,
  /// its points on the curved faces; the target is met along the contact surface's normal.
  [[nodiscard]] ProjectedTriangle project_triangle(const SurfaceTriangle& triangle) const;
  /// The target's nearest point on the line through x along the unit vector n, which leaves the
  /// contact surface; only target, s, gap, turn, x and normal are given.
  [[nodiscard]] std::optional<ProjectionPoint> project_along_normal(const Vec3& x,
                                                                    const Vec3& n) const;

private:
  struct Frame;
  void see_target(const Frame& frame, std::size_t target, ProjectedTriangle& projection) const;
  [[nodiscard]] bool meet(std::size_t face, ProjectionPoint& point) const;
  /// look(), no farther than `far` either way.
  [[nodiscard]] std::optional<ProjectionPoint> look_as_far(const Vec3& x, const Vec3& n,
                                                           double far) const;

  const SpaceSurface& contact_;
  const SpaceSurface& target_;
  double reach_ = 0.0;
  double size_ = 0.0;                       ///< of the target's triangles, on average
  geometry::BoxTree<3> tree_;               ///< of the target's triangles
  std::vector<std::array<Vec3, 3>> corner_; ///< [triangle of the target]
};

} // namespace spricka::contact
