// SPDX-License-Identifier: GPL-3.0-or-later
#include "program/verify/deck_list.hpp"

#include "base/csv.hpp"
#include "base/diagnostics.hpp"
#include "base/input_file.hpp"
#include "base/output_file.hpp"
#include "program/trials/child_run.hpp"

#include <algorithm>
#include <iterator>
#include <map>
#include <sstream>
#include <system_error>

#include <fmt/format.h>
#include <fnmatch.h>

namespace spricka::program {

namespace {

namespace fs = std::filesystem;

// The rows of a table beside the decks; none where there is no table.
std::vector<base::CsvRecord> records_of(const fs::path& file) {
  return fs::exists(file)
             ? base::parse_csv_records(base::read_file(file, base::largest_number_file))
             : std::vector<base::CsvRecord>();
}

std::map<std::string, DeckCost> read_costs(const fs::path& file) {
  std::map<std::string, DeckCost> costs;
  for (const base::CsvRecord& row : records_of(file)) {
    costs[row.text("deck")] = {.cpu = row.number("cpu", 0.0),
                               .memory = bytes_from_megabytes(row.number("memory", 0.0))};
  }
  return costs;
}

std::vector<std::string> blank_separated(const std::string& text) {
  std::istringstream in(text);
  return {std::istream_iterator<std::string>(in), std::istream_iterator<std::string>()};
}

void mark_quick(std::vector<ListedDeck>& decks) {
  std::vector<ListedDeck*> by_cost;
  for (ListedDeck& deck : decks) {
    if (deck.cost) {
      by_cost.push_back(&deck);
    }
  }
  std::ranges::stable_sort(by_cost, {}, [](const ListedDeck* deck) { return deck->cost->cpu; });
  double sum = 0.0;
  for (ListedDeck* deck : by_cost) {
    sum += deck->cost->cpu;
    if (sum > quick_budget) {
      break;
    }
    deck->quick = true;
  }
}

bool matches(const ListedDeck& deck, const std::string& word) {
  return word == "all" || (word == "quick" && deck.quick) ||
         fnmatch(word.c_str(), deck.name.c_str(), 0) == 0 ||
         fnmatch(word.c_str(), deck.file.filename().c_str(), 0) == 0;
}

bool about_the_same(double a, double b) {
  return a <= 1.5 * b && b <= 1.5 * a;
}

} // namespace

std::vector<ListedDeck> list_decks(const fs::path& folder) {
  const std::map<std::string, DeckCost> costs = read_costs(folder / costs_name);
  std::vector<ListedDeck> decks;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
    if (entry.path().extension() == ".deck") {
      ListedDeck deck{.name = entry.path().stem().string(),
                      .file = entry.path(),
                      .cost = std::nullopt,
                      .quick = false};
      if (const auto found = costs.find(deck.name); found != costs.end()) {
        deck.cost = found->second;
      }
      decks.push_back(std::move(deck));
    }
  }
  std::ranges::sort(decks, {}, &ListedDeck::name);
  mark_quick(decks);
  return decks;
}

std::vector<ListedDeck> select_decks(const std::vector<ListedDeck>& decks,
                                     const std::vector<std::string>& asked,
                                     base::OptionalFailure& trouble) {
  for (const std::string& word : asked) {
    if (std::ranges::none_of(decks, [&](const ListedDeck& d) { return matches(d, word); })) {
      std::vector<std::string> names{"quick", "all"};
      for (const ListedDeck& deck : decks) {
        names.push_back(deck.name);
      }
      trouble = base::OperationFailure{.kind = base::ProgramOutcome::usage,
                                       .why = fmt::format("there is no deck '{}'", word),
                                       .hint = base::make_spelling_hint(word, names)};
      return {};
    }
  }
  std::vector<ListedDeck> chosen;
  for (const ListedDeck& deck : decks) {
    if (std::ranges::any_of(asked, [&](const std::string& word) { return matches(deck, word); })) {
      chosen.push_back(deck);
    }
  }
  return chosen;
}

void write_deck_costs(const fs::path& folder, const std::vector<ListedDeck>& decks,
                      const std::vector<std::pair<std::string, DeckCost>>& found) {
  std::string text = "# What each deck takes on one thread: CPU seconds, MB at most. `spricka "
                     "verify --costs` writes it,\n# the tiers of `spricka verify` come from it.\n"
                     "deck,cpu,memory\n";
  for (const ListedDeck& deck : decks) {
    std::optional<DeckCost> cost = deck.cost;
    for (const auto& [name, now] : found) {
      if (name == deck.name &&
          !(cost && about_the_same(cost->cpu, now.cpu) &&
            about_the_same(static_cast<double>(cost->memory), static_cast<double>(now.memory)))) {
        cost = now;
      }
    }
    if (cost) {
      text += fmt::format("{},{:.2g},{:.2g}\n", deck.name, cost->cpu, megabytes(cost->memory));
    }
  }
  base::write_atomically(folder / costs_name, text);
}

std::vector<BenchmarkProblem> read_benchmark_coverage(const fs::path& folder) {
  std::vector<BenchmarkProblem> problems;
  for (const base::CsvRecord& row : records_of(folder / problems_name)) {
    problems.push_back({.name = row.text("problem"),
                        .title = row.text("title"),
                        .decks = blank_separated(row.text("decks")),
                        .tests = blank_separated(row.text("tests")),
                        .remark = row.text("remark")});
  }
  return problems;
}

} // namespace spricka::program
