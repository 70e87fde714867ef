// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/source.hpp"
#include "model/forward.hpp"

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace spricka::archive {

/// 32 hexadecimal digits that stand for all that the results of a deck depend on: the program's
/// version, the texts of deck, includes and -D, the files that $IMPORT names (and those that a .geo
/// names between quotes), and the values of a sweep's point. Where the files lie and when they were
/// written makes no difference.
std::string compute_deck_digest(const base::SourceTexts& sources, const model::Model& model,
                                const std::vector<std::pair<std::string, double>>& sweep_values);

/// How much of deck, includes and the files of compute_deck_digest() there is to be read [bytes].
std::uintmax_t count_deck_input_bytes(const base::SourceTexts& sources, const model::Model& model);

/// The text of a file that a card brings in, and those that a .geo names between quotes; empty
/// where there is none.
std::string read_imported_file_texts(const std::string& file);

} // namespace spricka::archive
