// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/outcome.hpp"
#include "deck/deck_text.hpp"
#include "model/model.hpp"

#include <cstddef>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

/// Changes of a deck's cards, and the steps that a session adds to them. What a value means is for
/// the deck's own reading to say.
namespace spricka::program {

/// The cards of a deck that has been read without mistakes, with what -D NAME=expression says of
/// its parameters, and the files that they stand in.
base::OptionalFailure
read_checked_deck_cards(const std::filesystem::path& deck,
                        const std::vector<std::pair<std::string, std::string>>& defines,
                        deck::DeckCardList& text, std::vector<std::filesystem::path>& files);

/// All cards that another size of a crack leaves as they are, as one text to compare.
std::string cards_without_cracks_text(const deck::DeckCardList& text);

/// A header as a deck has it, `$CRACK NAME=C A0=6`: its keys take the places of those that the card
/// has, and of those that exclude them. The card is the one with that name (or with the same value
/// of the first key that such cards must have), else the only one of its kind. `changed`: which one
/// it was.
base::OptionalFailure set_card_keys(const std::string& header, deck::DeckCardList& text,
                                    std::size_t& changed);

/// A line of $PARAMETER, `F = 110[kN]`: the expression takes the place of the deck's.
base::OptionalFailure set_parameter(const std::string& line, deck::DeckCardList& text);

/// Takes a card out of the deck and leaves its lines as comments behind the card before it.
void comment_out_card(deck::DeckCardList& text, std::size_t card);

/// What a deck writes for an action: "LOAD PULL 2".
std::string step_action_text(const model::Model& model, const model::StepAction& action);

/// Puts further steps at the end of a deck, the last with the name NOW (or the next that is free).
/// A contact that no step mounted, or a fit that none named, is in force from the beginning: where
/// a step behind names it, the first one names it too.
void append_steps(const model::Model& model, const std::vector<model::Step>& steps,
                  deck::DeckCardList& text);

} // namespace spricka::program
