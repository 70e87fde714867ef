// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "deck/deck_text.hpp"
#include "model/forward.hpp"

namespace spricka::program {

/// Puts ten steps in the place of each load path, from its first loads to its last, and leaves out
/// the checks of the path. False, and nothing changed, where there is no path or a spectrum needs
/// it. The steps stand behind those of the deck, which end with other loads.
bool replace_load_paths_by_steps(deck::DeckCardList& text, const model::Model& model);

} // namespace spricka::program
