// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "contact/constraint.hpp"

#include <vector>

namespace spricka::contact {

/// A place where one surface of a pair ends while the other goes on: the end of a rigid line, the
/// edge of a punch or of a hub, the mouth of a crack. Where contact is closed up to it, the exact
/// pressure has no bound, and the largest one found belongs to the mesh.
struct SharpEnd {
  Vec2 x = Vec2::Zero();
  std::vector<base::NodeId> nodes; ///< contact nodes whose pressure acts there
};

/// All such places of a pair, in the order of the contact surface. Corners that stand on a rigid
/// target are not among them: a right angle has a bounded pressure there.
std::vector<SharpEnd> sharp_ends(const PairRows& pair);

} // namespace spricka::contact
