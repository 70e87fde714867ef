// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/id.hpp"
#include "base/source.hpp"
#include "base/vec.hpp"

#include <optional>
#include <string>

/// Pairs of surfaces in contact, and rigid targets.
namespace spricka::model {

/// A line and an arc are of the plane, the others of space.
enum class RigidTargetShape { line, arc, plane, cylinder, cone, sphere };

/// A rigid target. Shapes of space have no ends.
struct RigidTarget {
  std::string name;
  RigidTargetShape shape = RigidTargetShape::line;
  /// First point of a line, centre of an arc or a sphere, point of a plane or an axis.
  base::Vec3 first = base::Vec3::Zero();
  /// Second point of a line, the body is on the left, or of an axis; a plane's normal runs from the
  /// first to it, towards the body.
  base::Vec3 second = base::Vec3::Zero();
  double radius = 0.0;        ///< negative for a bore; of a cone at the first point [length]
  double second_radius = 0.0; ///< of a cone at the second point, with the sign of the other
  base::SourceSpan span;
};

enum class ContactType { unilateral, bonded };
enum class PairingMethod { node, segment };
enum class PressureRecovery { lumped, consistent };
/// Where solids have a pressure of their own: at all nodes of faces, or at their corners.
enum class MultiplierNodes { nodes, corners };

struct Contact {
  std::string name;
  base::FaceSetId slave;
  base::FaceSetId master; ///< invalid where the other surface is `rigid`
  base::RigidId rigid;
  ContactType type = ContactType::unilateral;
  /// Declared normal gap, used exactly instead of the faceted geometry [length]: GAP = +g,
  /// INTERFERENCE = -d, DIAMETRAL = -d/2. Empty: measured from the geometry.
  std::optional<double> gap;
  double mu = 0.0;
  PairingMethod pairing = PairingMethod::segment;
  PressureRecovery recovery = PressureRecovery::lumped;
  MultiplierNodes multiplier = MultiplierNodes::nodes;
  base::SourceSpan span;
};

} // namespace spricka::model
