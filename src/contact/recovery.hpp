// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "contact/constraint.hpp"

#include <memory>
#include <vector>

/// Pressures from contact forces (the paper's equations 6 to 8).
namespace spricka::contact {

struct NodePressure {
  base::NodeId node;
  Vec2 x = Vec2::Zero();
  double theta = 0.0;        ///< about the circle's centre from +x [rad]; straight surfaces: 0
  double arc = 0.0;          ///< length along its chain
  double p_lumped = 0.0;     ///< R_j / integral of N_j [stress]
  double p_consistent = 0.0; ///< of C p = R, C = integral N N^T
  double gap = 0.0;          ///< row gap over row area [length]
  bool closed = false;
  int lip = 0;               ///< +1 and -1 at the two ends of a chain that meet in one point
};

struct PairPressure {
  std::vector<NodePressure> nodes;        ///< of the side that carries the multipliers
  base::Vec3 force_on_slave = base::Vec3::Zero(); ///< deck's slave
  double mean_pressure = 0.0;   ///< normal multipliers over the paired area
  double max_penetration = 0.0; ///< [length], 0 or more
  double arc_from = 0.0, arc_to = 0.0; ///< longest closed arc [rad], or arc length if straight
  int closed = 0;
};

/// lambda [normal rows, then tangent rows], gap [normal rows] weighted, closed [normal rows].
PairPressure recover_pressure(const PairRows& pair, const base::Vector& lambda,
                              const base::Vector& gap, const std::vector<bool>& closed);

} // namespace spricka::contact
