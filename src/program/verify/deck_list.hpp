// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/outcome.hpp"

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace spricka::program {

/// The table beside the decks with what each of them costs: deck,cpu,memory (seconds on one thread
/// and MB). `spricka verify --costs` writes it.
inline constexpr const char* costs_name = "costs.csv";

struct DeckCost {
  double cpu = 0.0;       ///< [s]
  std::size_t memory = 0; ///< [bytes]
};

/// A deck of the folder.
struct ListedDeck {
  std::string name; ///< without .deck
  std::filesystem::path file;
  std::optional<DeckCost> cost; ///< empty: the table does not have it, so that it is in no tier
  bool quick = false;           ///< belongs to the tier `quick`
};

/// Memory stands in tables in MB [bytes].
inline constexpr double bytes_of_MB = 1e6;

/// CPU time that the decks of the tier `quick` may take together [s]: a minute of two cores, with
/// two fifths to spare for machines that are slower, and for the last deck on one core.
inline constexpr double quick_budget = 0.6 * 2 * 60;
/// The same of all decks: ten minutes of two cores.
inline constexpr double whole_budget = 0.6 * 2 * 600;

/// The decks of a folder by name, with their costs; `quick` are the cheapest that fit the budget.
/// Throws std::system_error for a folder or table that cannot be read.
std::vector<ListedDeck> list_decks(const std::filesystem::path& folder);

/// Those that are asked for: "quick", "all", names or shell patterns, each once, by name. A word
/// that names none gives a OperationFailure with what was probably meant.
std::vector<ListedDeck> chosen_decks(const std::vector<ListedDeck>& decks,
                                     const std::vector<std::string>& asked, base::Trouble& trouble);

/// The table renewed by what decks were found to cost. Figures that are right within a half stay,
/// so that the table changes when a deck does; decks that are gone go. Throws std::system_error.
void write_costs(const std::filesystem::path& folder, const std::vector<ListedDeck>& decks,
                 const std::vector<std::pair<std::string, DeckCost>>& found);

} // namespace spricka::program
