// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "contact/surface.hpp"
#include "model/forward.hpp"

#include <array>
#include <optional>
#include <string>
#include <vector>

/// Where surfaces face each other, as points to integrate over. The only part of SEGMENT pairing
/// that knows the dimension.
namespace spricka::contact {

/// One integration point. Reference coordinates have one place in use in the plane.
struct MortarPoint {
  std::size_t facet = 0;  ///< of the contact surface
  std::size_t target = 0; ///< facet of the target; 0 on a rigid one, which has none
  Vec2 r = Vec2::Zero();  ///< on the facet
  Vec2 s = Vec2::Zero();  ///< on the target's facet
  base::Vec3 x = base::Vec3::Zero();
  base::Vec3 normal = base::Vec3::Zero(); ///< unit, from the contact surface towards the target
  std::array<base::Vec3, 2> tangent{base::Vec3::Zero(), base::Vec3::Zero()}; ///< plane: the first
  double weight = 0.0; ///< area that the point stands for, with the depth of the section
  double gap = 0.0;    ///< along the normal [length]
  /// The same where surfaces whose nodes lie on circles were those circles; else as `gap`.
  double round_gap = 0.0;
};

/// A point of the contact surface whether something lies opposite or not.
struct SurfaceQuadraturePoint {
  std::size_t facet = 0;
  Vec2 r = Vec2::Zero();
  double weight = 0.0;
};

struct MortarPoints {
  std::vector<MortarPoint> points;             ///< facet by facet
  std::vector<SurfaceQuadraturePoint> surface; ///< over all of every facet
  bool found = false;                          ///< the surfaces face each other somewhere
  std::string trouble;                         ///< why there are no points though they do
};

/// The points at which a contact surface sees a target along its normals, or along those of a rigid
/// one. In the plane: Gauss points of degree 9 on the stretches of segment.hpp. A declared gap
/// stands in the place of the measured ones.
MortarPoints mortar_points(const ContactSurface& contact, const ContactSurface& target,
                           std::optional<double> declared_gap);
MortarPoints mortar_points(const ContactSurface& contact, const model::RigidTarget& target,
                           std::optional<double> declared_gap);

} // namespace spricka::contact
