// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "contact/constraint.hpp"
#include "contact/node_pressure.hpp"

#include <vector>

/// Pressures from contact forces, C p = R with the surface mass C (Ansell and Fredriksson,
/// equations 6 to 8; manual, contact.9), lumped or consistent. SEGMENT pairs have a pressure of
/// their own, the multiplier, which is never negative: it stands for the consistent one. No
/// pressure of a contact that can part is negative.
namespace spricka::contact {

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

/// Recovers the pressures of a pair from lambda [normal rows, then tangent rows] [stress], weighted
/// gap [normal rows] and closed [normal rows]. `may_pull`: a bonded pair, whose pressures may be
/// negative.
PairPressure recover_pressure(const PairRows& pair, const base::Vector& lambda,
                              const base::Vector& gap, const std::vector<bool>& closed,
                              bool may_pull = false);

} // namespace spricka::contact
