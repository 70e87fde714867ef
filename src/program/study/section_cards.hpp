// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "deck/deck_text.hpp"
#include "model/forward.hpp"
#include "model/freedoms.hpp"
#include "model/mesh.hpp"
#include "sense/section.hpp"

#include <string>

/// Cards of a section: its mesh written out, loads and supports of the solid as it has them.
namespace spricka::program {

/// What of the loads differs along the axis, or round it, or acts across the section; empty:
/// nothing.
std::string describe_varying_load(const model::Model& model,
                                  const sense::PlaneSectionMesh& section);

/// Gives a $LOAD card the values of the section; what it cannot say goes to an empty `reason`.
void project_load_onto_section(deck::DeckCard& card, const sense::SectionPlane& plane,
                               std::string& reason);

/// Whether supports hold the radius of a round section in the section.
bool support_holds_radius(const model::Model& model, const sense::PlaneSectionMesh& section,
                          const model::NodeSetFreedomRole& freedom);

/// Whether all nodes of both flat faces, or at both ends of a sector, are held across them.
bool ends_are_held(const model::Model& model, const sense::PlaneSectionMesh& section);

/// A name that no set of the mesh has in any net: `wanted`, or with underscores behind it.
std::string unused_set_name(const model::Mesh& mesh, std::string wanted);

/// Writes a mesh out: nets with nodes, elements and those of `cards` that stand in them, then what
/// stands outside of nets; all sets that have names and members under their names, those of several
/// nets by parts in each. `mesh` are the nets of `model`, flat.
deck::DeckCardList write_mesh_cards(const model::Model& model, const model::Mesh& mesh,
                                    const deck::DeckCardList& cards);

} // namespace spricka::program
