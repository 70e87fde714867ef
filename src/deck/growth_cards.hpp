// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/diagnostics.hpp"
#include "base/source.hpp"
#include "deck/deck_text.hpp"
#include "model/model.hpp"

#include <filesystem>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

/// The cards that say how fast cracks grow, read anew for a deck that has been read.
namespace spricka::deck {

/// Whether two texts of a deck differ only in what $GROW says of its law, cycles and ends, in
/// $LAW, $SPECTRUM and $INTERACTION, and in parameters that stand nowhere else but in checks and
/// outputs: all else that the deck says is the same. `script_constants`: parameters (upper case)
/// that geometry scripts take.
bool differ_in_growth_law_alone(const DeckCardList& before, const DeckCardList& after,
                                const std::set<std::string>& script_constants);

/// What those cards make of a model.
struct GrowthCards {
  std::optional<model::CrackGrowthSettings> growth;
  std::vector<model::SpectrumDefinition> spectra;
  std::vector<model::LoadInteractionDefinition> interactions;
  std::vector<std::pair<std::string, double>> parameters; ///< as written
};

/// Reads $PARAMETER, $LAW, $SPECTRUM, $INTERACTION and $GROW of a deck whose other cards have made
/// `model`. `file` is the deck's, as messages name it and as files of cards count from. The cards
/// become a text of `sources`; mistakes go to `diagnostics`, then the result is empty.
std::optional<GrowthCards> read_growth_cards(const model::Model& model, const DeckCardList& deck,
                                             const std::filesystem::path& file,
                                             base::SourceTexts& sources,
                                             base::Diagnostics& diagnostics);

} // namespace spricka::deck
