// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "program/study/deck_edits.hpp"
#include "program/study/joint.hpp"
#include "program/study/variant_runs.hpp"

#include <filesystem>
#include <string>
#include <vector>

/// Simpler models of a deck's joint, made by rewriting its cards.
namespace spricka::program {

/// One model of the joint; without a text the scene has no place for it.
struct ModelVariant : RewrittenDeck, DeckVariant {
  std::string words;   ///< what is simplified, a sentence
  bool simpler = true; ///< false: another model, no simpler one; never the one that is enough
};

/// All variants, the richest (the deck itself, without its checks and requests) first: a half by
/// symmetry, without friction, all mounted at once, fits but bonded, without interference, bonded,
/// stiff or rigid pressing bodies, pressures in their place, the other plane state; of solids their
/// sections. Their decks are written into `folder`.
std::vector<ModelVariant> make_model_variants(const StudiedDeck& deck, const Joint& joint,
                                              const std::filesystem::path& folder);

} // namespace spricka::program
