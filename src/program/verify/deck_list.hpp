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

/// Memory [bytes] of what tables have [MB].
inline std::size_t bytes_from_megabytes(double megabytes) {
  return static_cast<std::size_t>(1e6 * megabytes);
}

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
std::vector<ListedDeck> select_decks(const std::vector<ListedDeck>& decks,
                                     const std::vector<std::string>& asked,
                                     base::OptionalFailure& trouble);

/// The table renewed by what decks were found to cost. Figures that are right within a half stay,
/// so that the table changes when a deck does; decks that are gone go. Throws std::system_error.
void write_deck_costs(const std::filesystem::path& folder, const std::vector<ListedDeck>& decks,
                      const std::vector<std::pair<std::string, DeckCost>>& found);

/// The table beside the decks that says which of them stands for which problem of the open
/// collections: problem,title,decks,tests,remark.
inline constexpr const char* problems_name = "problems.csv";

/// A problem of the open collections.
struct BenchmarkProblem {
  std::string name; ///< "C03"
  std::string title;
  std::vector<std::string> decks; ///< by name
  std::vector<std::string> tests; ///< other than decks: names of CTest's
  std::string remark;             ///< of one that has neither: why it is not covered

  [[nodiscard]] bool is_covered() const { return !decks.empty() || !tests.empty(); }
};

/// The problems of a folder of decks, in the order of the table; none where there is no table.
/// Throws std::system_error.
std::vector<BenchmarkProblem> read_benchmark_coverage(const std::filesystem::path& folder);

} // namespace spricka::program
