// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/id.hpp"
#include "base/vec.hpp"

namespace spricka::contact {

/// Pressure, shear and gap at one node of the surface that carries the multipliers.
struct NodePressure {
  base::NodeId node;
  base::Vec3 x = base::Vec3::Zero();
  double theta = 0.0;        ///< about the circle's centre or the axis from +x [rad]; else 0
  double arc = 0.0;          ///< length along the deck's slave (slave_places.hpp); in space along
                             ///< the axis of a cylinder or cone
  double p_lumped = 0.0;     ///< R_i over the row sum of C [stress]
  double p_consistent = 0.0; ///< NODE: of C p = R; SEGMENT: the multiplier
  /// Shear traction on the slave along its surface, its body on the left [stress]: of the
  /// tangential forces as p_lumped and p_consistent of the normal ones; 0 where there are none.
  double q_lumped = 0.0;
  double q_consistent = 0.0;
  base::Vec3 shear = base::Vec3::Zero(); ///< in space: q_lumped as a vector
  int row = -1;                          ///< normal row of the node, -1: not paired
  double gap = 0.0;                      ///< row gap over row area [length]
  bool closed = false;
  int crack_face = 0; ///< +1 and -1 at the two ends of a chain that meet in one point
};

} // namespace spricka::contact
