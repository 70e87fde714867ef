// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "program/study/deck_edits.hpp"
#include "program/study/joint.hpp"

namespace spricka::program {

/// Makes what only presses rigid in `text`: a body that is loaded by a modulus 1e4 times as large,
/// as rigid targets do not move; one that stands in one contact and carries nothing by a rigid
/// target in the place of its surface, where that is straight or round. Fits of such contacts are
/// taken from `steps`, the deck as it was given.
RewrittenDeck make_pressing_bodies_rigid(const model::Model& model, const Joint& joint,
                                         deck::DeckCardList text, const deck::DeckCardList& steps);

} // namespace spricka::program
