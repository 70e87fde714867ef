// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "deck/context.hpp"
#include "model/cracks.hpp"

#include <array>
#include <optional>

namespace spricka::deck {

/// The ellipse of a flaw that is told by words: $CRACK AT= one face set for a surface flaw, two for
/// a corner flaw where they meet, DEPTH and LENGTH, and a place by ANGLE or coordinates. A corner
/// flaw is normal to the edge, DEPTH along the first face and LENGTH along the second; a surface
/// flaw is normal to the face, its mouth along ALONG or the axis of a round face. Angles of the
/// front count from the (second) face into the body. Empty after an error, which is reported.
std::optional<model::PlanarCrack> place_flaw(DeckContext& context, const CheckedCard& card);

/// In the plane: mouth and tip of a flaw on the face set of AT, an edge of the body there, at right
/// angles to it, at ANGLE round a circle or at coordinates. Empty after an error, which is
/// reported.
std::optional<std::array<base::Vec3, 2>> place_plane_flaw(DeckContext& context,
                                                          const CheckedCard& card);

} // namespace spricka::deck
