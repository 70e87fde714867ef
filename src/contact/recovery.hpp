// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "contact/constraint.hpp"

#include <vector>

/// Pressures from contact forces, C p = R with the surface mass C (the paper's equations 6 to 8),
/// lumped or consistent. SEGMENT pairs have a pressure of their own, the multiplier, which is never
/// negative: it stands for the consistent one. No pressure of a contact that can part is negative.
namespace spricka::contact {

struct NodePressure {
  base::NodeId node;
  Vec2 x = Vec2::Zero();
  double theta = 0.0;        ///< about the circle's centre from +x [rad]; straight surfaces: 0
  double arc = 0.0;          ///< length along the deck's slave (slave_places.hpp)
  double p_lumped = 0.0;     ///< R_i over the row sum of C [stress]
  double p_consistent = 0.0; ///< NODE: of C p = R; SEGMENT: the multiplier
  /// Shear traction on the slave along its surface, its body on the left [stress]: of the
  /// tangential forces as p_lumped and p_consistent of the normal ones; 0 where there are none.
  double q_lumped = 0.0;
  double q_consistent = 0.0;
  int row = -1;     ///< normal row of the node, -1: not paired
  double gap = 0.0; ///< row gap over row area [length]
  bool closed = false;
  int lip = 0; ///< +1 and -1 at the two ends of a chain that meet in one point
};

struct PairPressure {
  std::vector<NodePressure> nodes;                ///< of the side that carries the multipliers
  base::Vec3 force_on_slave = base::Vec3::Zero(); ///< deck's slave
  double mean_pressure = 0.0;                     ///< normal multipliers over the part in contact
  double min_pressure = 0.0;                      ///< of the normal multipliers
  double max_pressure = 0.0;
  double max_penetration = 0.0;        ///< [length], 0 or more
  double arc_from = 0.0, arc_to = 0.0; ///< longest closed arc [rad], or arc length if straight
  int closed = 0;
};

/// lambda [normal rows, then tangent rows], gap [normal rows] weighted, closed [normal rows].
/// `may_pull`: of a bonded pair.
PairPressure recover_pressure(const PairRows& pair, const base::Vector& lambda,
                              const base::Vector& gap, const std::vector<bool>& closed,
                              bool may_pull = false);

} // namespace spricka::contact
