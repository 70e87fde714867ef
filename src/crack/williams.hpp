// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/vec.hpp"
#include "model/forward.hpp"

#include <cstddef>

namespace spricka::crack {

/// Where a plane crack tip stands and which way it looks: e1 along the growth direction, e2 to its
/// left; the crack lies on x1 < 0.
struct TipFrame {
  base::Vec2 x = base::Vec2::Zero();
  base::Vec2 e1 = base::Vec2::UnitX();
  base::Vec2 e2 = base::Vec2::UnitY();
};

/// A point seen from the tip, theta from e1 in -pi .. pi.
struct PolarCoordinates {
  double r = 0.0, theta = 0.0;
};
/// Polar coordinates of a point about a tip: distance [length] and angle [rad] from e1.
PolarCoordinates polar_coordinates(const TipFrame& tip, const base::Vec2& at);
/// The same of a point of a face whose outer normal is n: round-off does not take a point of one
/// crack face to the other.
PolarCoordinates polar_coordinates_on_face(const TipFrame& tip, const base::Vec2& at,
                                           const base::Vec2& n);

/// Kolosov's constant: 3 - 4 nu in plane strain, (3 - nu)/(1 + nu) in plane stress.
double kolosov_constant(double nu, model::StressState state);

/// What the fields in a section depend on: shear modulus [stress], Kolosov's constant, and a length
/// to count logarithms in, as a rigid motion is free.
struct SectionBody {
  double mu = 0.0, kappa = 0.0;
  double unit = 1.0;
};
/// Of a plane body.
SectionBody make_section_body(const model::ElasticMaterial& material, model::StressState state,
                              double unit = 1.0);

/// The number of the field of a unit force per thickness, along the growth direction, at the tip of
/// a half-infinite crack (the auxiliary field of T: Kfouri 1986): s_rr = - cos(theta) / (pi r) is
/// its only stress (manual, crack.24, crack.25). Those of K1, K2, K3 = 1 have 1 to 3.
inline constexpr std::size_t line_force_auxiliary = 4;

/// A point off the front in the section across it, with what all fields share.
struct SectionPolarPoint {
  double r = 0.0, theta = 0.0;
  double c1 = 0.0, s1 = 0.0; ///< cosine and sine of theta/2
  double C = 0.0, S = 0.0;   ///< of theta
  double c3 = 0.0, s3 = 0.0; ///< of 3 theta/2

  SectionPolarPoint(double radius, double angle);
};

/// Displacements along e1 and e2 of the section and across it as a function of y and z along these,
/// with derivatives.
struct SectionField {
  base::Vec3 w, w_y, w_z, w_yy, w_yz, w_zz;
};
/// Of auxiliary field 1 to 4 (Williams 1957; manual, crack.6, crack.24, crack_space.3).
SectionField section_field(std::size_t auxiliary, const SectionPolarPoint& at,
                           const SectionBody& body);

/// Displacement gradient du_i/dx_j in global axes of auxiliary field 1, 2 or 4 in the plane, at a
/// point off the tip.
Eigen::Matrix2d near_tip_gradient(const TipFrame& tip, const PolarCoordinates& at,
                                  std::size_t auxiliary, const SectionBody& body);
/// The displacement itself, global axes.
base::Vec2 near_tip_displacement(const TipFrame& tip, const PolarCoordinates& at,
                                 std::size_t auxiliary, const SectionBody& body);

} // namespace spricka::crack
