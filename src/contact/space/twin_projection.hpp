// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "contact/space/surface_projection.hpp"

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

/// Surfaces that lie on one another node by node, as the two faces of a crack do: what a triangle
/// sees is known without being looked for.
namespace spricka::contact {

/// The face of the target that lies on a face of the contact surface.
struct CoincidentFace {
  std::size_t face = 0;
  std::array<Vec2, 4> corner{}; ///< of the contact surface's face: reference places on it
};

/// [face of `own`] its twin, whose corners are at the same places. Empty: a face has
/// none.
std::optional<std::vector<CoincidentFace>> match_coincident_faces(const FacetSurface& own,
                                                                  const FacetSurface& other);

/// What a triangle sees of the twin of its face: all of it, without a gap, by a rule of degree 5.
OppositePointsOfElement project_triangle_on_matching_face(const FacetSurface& own,
                                                          const CoincidentFace& twin,
                                                          const HatElement& triangle);

} // namespace spricka::contact
