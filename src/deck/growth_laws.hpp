// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "deck/context.hpp"
#include "model/crack_growth.hpp"

#include <filesystem>
#include <vector>

/// Growth laws by name: of the deck, of a file beside it, and those that ship.
namespace spricka::deck {

/// $LAW. Mistakes are added to the context's.
void build_growth_laws(DeckContext& context);

/// The law of $GROW: LAW and its constants, or MATERIAL, looked for in the deck, in materials.deck
/// beside it, then in the file that ships; with the toughness of its THICK. Mistakes are added to
/// the context's; then the law is not to be used.
model::GrowthLawDefinition growth_law_of_card(DeckContext& context, const CheckedCard& card);

/// The file of growth laws that ships; empty: it is not there.
std::filesystem::path find_shipped_growth_laws();

/// All laws of such a file, in these units. Trouble with the file throws std::system_error;
/// mistakes in it are added to `diagnostics`.
std::vector<model::GrowthLawDefinition> read_growth_law_file(const std::filesystem::path& file,
                                                             const base::UnitSystem& units,
                                                             base::SourceTexts& sources,
                                                             base::Diagnostics& diagnostics);

} // namespace spricka::deck
