// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "contact/space/facet_surface.hpp"

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

/// What a contact surface has opposite, point by point: all that rows, pressures and slides know of
/// how two surfaces lie.
namespace spricka::contact {

/// Where a point of a contact surface lies on both surfaces.
struct PairQuadraturePoint {
  std::size_t target = 0;                        ///< facet of the target; 0 on a rigid one
  Vec2 r = Vec2::Zero();                         ///< on the contact surface's facet
  Vec2 s = Vec2::Zero();                         ///< on the target's
  Eigen::Vector3d hat = Eigen::Vector3d::Zero(); ///< hats of the nodes of its element
  Vec3 normal = Vec3::Zero(); ///< unit, from the contact surface towards the target
  double weight = 0.0;        ///< area that the point stands for, with the depth of the section
};

/// A point of a contact surface and what it meets of the target along its normal, or along that of
/// a rigid target.
struct PairPoint : PairQuadraturePoint {
  std::size_t facet = 0; ///< of the contact surface
  Vec3 x = Vec3::Zero();
  double turn = 0.0; ///< in space: cosine between the normal and the target's reversed
  double gap = 0.0;  ///< along the normal [length]
  /// The same where surfaces whose nodes lie on a circle or on one of the shapes of round.hpp were
  /// that; else as `gap`.
  double round_gap = 0.0;
};

/// What an element of a contact surface has opposite.
struct OppositePointsOfElement {
  std::vector<PairPoint> points; ///< facet by facet of the target
  /// Integrals of the hats over all of the element, whether something lies opposite or not.
  Eigen::Vector3d whole = Eigen::Vector3d::Zero();
  double flat_area = 0.0;        ///< of the plane triangle between the corners
  double flat_seen = 0.0;        ///< of it, what is covered; more than all: covered twice
  double unprojected_area = 0.0; ///< area of points whose normal met no target though it should
  std::string trouble;           ///< why there are no points though something lies opposite
};
using ElementProjector = std::function<OppositePointsOfElement(const HatElement&)>;

} // namespace spricka::contact
