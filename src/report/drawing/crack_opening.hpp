// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "results/results.hpp"

#include <optional>
#include <vector>

namespace spricka::report {

/// The plane that the points of a front lie in.
struct FittedFrontPlane {
  base::Vec3 centre = base::Vec3::Zero(); ///< middle of the points
  base::Vec3 normal = base::Vec3::Zero(); ///< unit, from the lower face to the upper
  double size = 0.0;                      ///< largest distance of a point from the centre
  /// Mean way of growth, at most 1 long, none of a front that is closed: the mouth is behind it.
  base::Vec3 growth = base::Vec3::Zero();
};

/// Empty where the points are no plane or too few to tell.
std::optional<FittedFrontPlane> fit_front_plane(const results::FrontResult& front);

/// A face on the upper side of a crack, and how far the lower one is away from it.
struct OpenedCrackFace {
  std::vector<base::NodeId> outline;
  double opening = 0.0; ///< along the normal, mean over the nodes [length]
  double sliding = 0.0; ///< in the plane [length]
};

/// Faces of the body's surface in the crack's plane that have another one in the same place.
std::vector<OpenedCrackFace> crack_face_openings(const results::CrackLengthResult& increment,
                                                 const results::LoadStepResult& step,
                                                 const FittedFrontPlane& frame);

} // namespace spricka::report
