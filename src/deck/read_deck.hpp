// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/diagnostics.hpp"
#include "base/source.hpp"
#include "deck/imported_step.hpp"
#include "deck/read_options.hpp"
#include "model/model.hpp"

#include <filesystem>
#include <optional>

namespace spricka::deck {

/// Reads a deck with its includes and imports, checks it in four passes and builds the model. All
/// mistakes of all passes go to `diagnostics`; with errors the result is empty. File trouble with
/// the deck itself throws std::system_error. What is known of imported
/// geometries goes to `imported`, if given, with errors too.
std::optional<model::Model> read_deck(const std::filesystem::path& deck,
                                      const DeckReadOptions& options, base::SourceTexts& sources,
                                      base::Diagnostics& diagnostics,
                                      ImportedGeometry* imported = nullptr);

} // namespace spricka::deck
