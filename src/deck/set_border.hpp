// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "model/mesh.hpp"

#include <functional>

namespace spricka::deck {

/// Areas of a set of faces (lengths in the plane): of its faces, and of the surface that its
/// condition holds on, faces next to them that it holds on in part included.
struct FaceSetConditionAreas {
  double taken = 0.0;
  double meant = 0.0;
};

/// `kept`: faces on which the condition holds at all nodes; `others`: what else there was to choose
/// from. Of these count the ones that go on from a face of the set by less than 45 degrees: a
/// condition that cuts out a bore holds on a strip of the plate's sides as well. By midpoints, to a
/// percent of a face.
FaceSetConditionAreas face_set_condition_areas(const model::Mesh& mesh,
                                               const std::vector<model::Face>& kept,
                                               const std::vector<model::Face>& others,
                                               const std::function<bool(const base::Vec3&)>& holds);

} // namespace spricka::deck
