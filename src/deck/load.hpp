// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/diagnostics.hpp"
#include "base/source.hpp"
#include "grammar/ast.hpp"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace spricka::deck {

/// The cards of a deck with those of its includes in their places. The $INCLUDE cards follow
/// what they bring.
struct DeckFileCards {
  std::vector<grammar::CardHeader> cards;
  bool incomplete = false; ///< an include could not be read
};

/// Reads the deck and its includes and checks the frame: $DECK first, $END last. Trouble with the
/// deck's own file throws std::system_error; with an include it is a deck error. With a `text` the
/// deck's own file is not read: the text stands for it.
DeckFileCards read_deck_and_includes(const std::filesystem::path& deck, base::SourceTexts& sources,
                                     base::Diagnostics& diagnostics,
                                     const std::optional<std::string>& text = {});

} // namespace spricka::deck
