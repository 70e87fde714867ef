// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "deck/deck_text.hpp"
#include "model/forward.hpp"
#include "model/mesh.hpp"

#include <string>

/// A plane mesh as cards.
namespace spricka::program {

/// A name that no set of the mesh has in any net: `wanted`, or with underscores behind it.
std::string unused_set_name(const model::Mesh& mesh, std::string wanted);

/// Writes a mesh out: nets with nodes, elements and those of `cards` that stand in them, then what
/// stands outside of nets; all sets that have names and members under their names, those of several
/// nets by parts in each. `mesh` are the nets of `model`, flat.
deck::DeckCardList write_mesh_cards(const model::Model& model, const model::Mesh& mesh,
                                    const deck::DeckCardList& cards);

} // namespace spricka::program
