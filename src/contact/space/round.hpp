// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/vec.hpp"

#include <optional>
#include <vector>

/// Planes, cylinders, cones and spheres: what surfaces of solids mostly are, met exactly.
namespace spricka::contact {

enum class AnalyticShapeKind { plane, cylinder, cone, sphere };

/// A shape that the nodes of a surface lie on.
struct AnalyticShape {
  AnalyticShapeKind kind = AnalyticShapeKind::plane;
  base::Vec3 point = base::Vec3::Zero(); ///< of the plane or axis; centre of a sphere
  base::Vec3 axis = base::Vec3::UnitZ(); ///< unit; of a plane its normal; of a sphere unused
  double radius = 0.0;                   ///< of a cone at `point`; of a plane unused [length]
  double slope = 0.0; ///< of a cone: how much wider it gets by a unit along the axis, above 0
  /// -1 where the body lies outside (a bore), +1 where it is the pin; of a plane +1 where its body
  /// lies behind the normal.
  double sense = 1.0;
  bool exact = false; ///< all nodes lie on it within 1e-6 of the radius
};

/// Distance of x from the shape, positive outside [length]; exact near it and on all of it but a
/// cone's tip.
double signed_distance(const AnalyticShape& round, const base::Vec3& x);
/// Gradient of that distance, unit; zero on an axis or in a centre.
base::Vec3 distance_gradient(const AnalyticShape& round, const base::Vec3& x);
/// Unit normal that leaves the body whose surface the shape is.
base::Vec3 outer_normal(const AnalyticShape& round, const base::Vec3& x);
/// How far along the unit vector n the shape is from x; none where n runs more than 60 degrees off
/// its normal.
std::optional<double> distance_along_direction(const AnalyticShape& round, const base::Vec3& x,
                                               const base::Vec3& n);

/// Whether the shape is one about an axis: a cylinder or a cone.
bool is_cylinder_or_cone(const AnalyticShape& round);
/// Angle about the axis of a cylinder or cone [rad] and place along it [length]; zero of others.
/// Angles count from +x, or where the axis is that, from +y.
struct CylindricalCoordinates {
  double angle = 0.0;
  double along = 0.0;
};
CylindricalCoordinates cylindrical_coordinates(const AnalyticShape& round, const base::Vec3& x);

/// A place on a surface and the unit normal there that leaves the body.
struct PointNormal {
  base::Vec3 x = base::Vec3::Zero();
  base::Vec3 normal = base::Vec3::Zero();
};

/// The shape that points lie on within 1e-4 of its radius, if it is one of the four and no wider
/// than 1e3 extents; `normals` at some places, whichever. A plane is one within 1e-6 of the extent.
std::optional<AnalyticShape> fit_analytic_shape(const std::vector<base::Vec3>& points,
                                                const std::vector<PointNormal>& normals,
                                                double extent);

} // namespace spricka::contact
