// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "deck/deck_text.hpp"
#include "model/forward.hpp"
#include "model/freedoms.hpp"
#include "sense/section.hpp"

#include <string>

/// Loads and supports of a solid, as its section has them.
namespace spricka::program {

/// What of the loads differs along the axis, or round it, or acts across the section; empty:
/// nothing.
std::string describe_varying_load(const model::Model& model, const sense::PlaneSection& section);

/// Gives a $LOAD card the values of the section; what it cannot say goes to an empty `reason`.
void project_load_onto_section(deck::DeckCard& card, const sense::SectionPlane& plane,
                               std::string& reason);

/// Whether supports hold the radius of a round section in the section.
bool support_holds_radius(const model::Model& model, const sense::PlaneSection& section,
                          const model::FreedomAssignment& freedom);

/// Whether all nodes of both flat faces, or at both ends of a sector, are held across them.
bool ends_are_held(const model::Model& model, const sense::PlaneSection& section);

} // namespace spricka::program
