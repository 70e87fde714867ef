// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/id.hpp"
#include "base/source.hpp"
#include "base/vec.hpp"

#include <optional>
#include <string>

/// Pairs of surfaces in contact, and rigid targets.
namespace spricka::model {

enum class RigidShape { line, arc };

/// A rigid target in the plane.
struct Rigid {
  std::string name;
  RigidShape shape = RigidShape::line;
  base::Vec3 first = base::Vec3::Zero();  ///< first point of a line, centre of an arc
  base::Vec3 second = base::Vec3::Zero(); ///< second point of a line; the body is on the left
  double radius = 0.0;                    ///< of an arc, negative for a bore [length]
  base::Span span;
};

enum class ContactType { unilateral, bonded };
enum class Pairing { node, segment };
enum class Recovery { lumped, consistent };

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
  Pairing pairing = Pairing::segment;
  Recovery recovery = Recovery::lumped;
  base::Span span;
};

} // namespace spricka::model
