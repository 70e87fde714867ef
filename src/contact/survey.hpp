// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "contact/surface.hpp"

#include <cstddef>
#include <vector>

namespace spricka::contact {

/// A part of a facet that sees another surface.
struct FacingFacetPart {
  std::size_t facet = 0;
  double measure = 0.0; ///< its length or area
  double gap = 0.0;     ///< [length]; of a part of an edge in its middle
};

/// What one surface sees of another along its normals, whatever gap a deck declares.
struct GapSurvey {
  std::size_t edges = 0;   ///< of the surface; in space its faces
  std::size_t facing = 0;  ///< of these, that see the other surface at least in part
  double length = 0.0;     ///< of the surface; in space its area
  double seen = 0.0;       ///< of it, the part that faces the other surface
  double gap_low = 0.0;    ///< smallest measured gap, negative where the surfaces overlap [length]
  double gap_high = 0.0;   ///< largest
  double gap_mean = 0.0;   ///< over the part that faces
  double angle_high = 0.0; ///< largest angle between one normal and the other reversed [rad]
  std::vector<FacingFacetPart> parts; ///< facet by facet

  /// Part of the surface that sees nothing, 0 to 1.
  [[nodiscard]] double unpaired_fraction() const {
    return length > 0.0 ? 1.0 - seen / length : 1.0;
  }
};

/// Surveys the segments that pairing uses: at their ends and at Gauss points between; in space at
/// its points.
GapSurvey survey_gaps(const ContactSurface& from, const ContactSurface& to);

/// The same for a rigid target, along its normals.
GapSurvey survey_gaps(const ContactSurface& from, const model::RigidTarget& to);

} // namespace spricka::contact
