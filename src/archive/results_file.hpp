// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/source.hpp"
#include "model/forward.hpp"
#include "results/results.hpp"
#include "results/store.hpp"

#include <filesystem>

namespace spricka::archive {

/// results.h5 of the run folder: the run whole, the tables that people ask for first, the deck's
/// texts and parameters, versions and units (manual/results_file.md). Its bytes depend on the deck
/// and the program only. Throws std::system_error.
void write_results_file(const std::filesystem::path& file, const base::SourceTexts& sources,
                        const model::Model& model, const results::RunResult& run);

/// Program, libraries and units as attributes of a folder.
void write_provenance(const results::StoreGroup& given, const model::Model& model);

/// Texts and parameters of a deck into a folder "deck".
void store_deck_texts(const results::StoreGroup& given, const base::SourceTexts& sources,
                      const model::Model& model);

} // namespace spricka::archive
