// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/diagnostics.hpp"
#include "base/source.hpp"
#include "deck/imported_script.hpp"
#include "deck/read_options.hpp"
#include "model/model.hpp"

#include <filesystem>
#include <optional>
#include <vector>

namespace spricka::deck {

/// Reads a deck with its includes and imports, checks it in four passes and builds the model. All
/// mistakes of all passes go to `diagnostics`; with errors the result is empty. File trouble with
/// the deck itself throws std::system_error. Constants of geometry scripts go to `scripts`, if
/// given.
std::optional<model::Model> read_deck(const std::filesystem::path& deck,
                                      const DeckReadOptions& options, base::SourceTexts& sources,
                                      base::Diagnostics& diagnostics,
                                      std::vector<ImportedScript>* scripts = nullptr);

} // namespace spricka::deck
