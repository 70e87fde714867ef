// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "deck/context.hpp"
#include "mesh/generate/generate.hpp"

/// What a $MESH card, whose header is sound, wants. Element numbers are those of the card, the type
/// of a shape other than a block is the default: that of a solid is swept from another one.
namespace spricka::deck {

/// TYPE of $MESH or $ELEMENT.
base::ElementType element_type_of_card(const CheckedCard& card);

mesh::BlockSpec block_spec(const CheckedCard& card); ///< of SHAPE=BLOCK, with its type
mesh::RingSpec ring_spec(const CheckedCard& card);   ///< of SHAPE=RING
mesh::LugSpec lug_spec(const CheckedCard& card);     ///< of SHAPE=LUG
mesh::PlateSpec plate_spec(const CheckedCard& card); ///< of SHAPE=PLATE

/// Whether the sizes of the card together make its shape. False after an error, which is reported.
bool check_mesh_shape(DeckContext& context, const CheckedCard& card);

} // namespace spricka::deck
