// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/source.hpp"
#include "base/vec.hpp"
#include "model/cracks.hpp"
#include "model/forward.hpp"
#include "model/mirror_plane.hpp"

#include <string>

/// Cracks of a model of which one side is kept.
namespace spricka::sense {

/// A plane across an axis, of which one side stays.
struct HalfModelPlane {
  int axis = 0;
  double at = 0.0;    ///< [length]
  double sign = 1.0;  ///< of the axis, towards the side that stays
  double reach = 0.0; ///< what is nearer lies in the plane [length]
  base::SourceSpan span;

  /// Distance from the plane, positive on the side that stays [length].
  [[nodiscard]] double signed_distance(const base::Vec3& x) const { return sign * (x[axis] - at); }
};

/// The plane x_axis = `at` [length] of a symmetric half; what lies in it is decided by the size of
/// the mesh.
HalfModelPlane make_half_model_plane(const model::Mesh& mesh, const model::MirrorPlane& request,
                                     double at);

/// Which crack has no half, and why; empty: all have one.
std::string describe_crack_without_half(const model::Model& model, const HalfModelPlane& plane);

/// Whether all of a crack lies on the side that goes.
bool lies_on_removed_side(const model::Model& model, const model::CrackDefinition& crack,
                          const HalfModelPlane& plane);

/// The face of a drawn crack in the plane that the side which stays does not have; invalid: it has
/// both, or none of its own.
base::FaceSetId find_missing_crack_face(const model::Model& model,
                                        const model::CrackDefinition& crack,
                                        const HalfModelPlane& plane);

/// Takes away cracks that lie beyond, with all that is about them. Those of a plane model that lie
/// across the plane begin in it, and those drawn in it run along its nodes from their mouth on.
void remove_cracks_beyond_plane(model::Model& model, const HalfModelPlane& plane);

} // namespace spricka::sense
