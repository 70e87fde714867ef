// SPDX-License-Identifier: GPL-3.0-or-later
#include "program/verify/deck_list.hpp"

#include "base/diagnostics.hpp"
#include "base/input_file.hpp"
#include "base/output_file.hpp"
#include "program/trials/csv_rows.hpp"

#include <algorithm>
#include <charconv>
#include <map>

#include <fmt/format.h>
#include <fnmatch.h>

namespace spricka::program {

namespace {

namespace fs = std::filesystem;

double number_of(const std::string& text) {
  double value = 0.0;
  std::from_chars(text.data(), text.data() + text.size(), value);
  return value;
}

std::map<std::string, DeckCost> read_costs(const fs::path& file) {
  std::map<std::string, DeckCost> costs;
  if (!fs::exists(file)) {
    return costs;
  }
  const auto rows = csv_rows(base::read_file(file, base::largest_number_file));
  for (std::size_t i = 1; i < rows.size(); ++i) {
    if (rows[i].size() >= 3) {
      costs[rows[i][0]] = {.cpu = number_of(rows[i][1]),
                           .memory = static_cast<std::size_t>(bytes_of_MB * number_of(rows[i][2]))};
    }
  }
  return costs;
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

std::vector<ListedDeck> chosen_decks(const std::vector<ListedDeck>& decks,
                                     const std::vector<std::string>& asked,
                                     base::Trouble& trouble) {
  for (const std::string& word : asked) {
    if (std::ranges::none_of(decks, [&](const ListedDeck& d) { return matches(d, word); })) {
      std::vector<std::string> names{"quick", "all"};
      for (const ListedDeck& deck : decks) {
        names.push_back(deck.name);
      }
      trouble = base::OperationFailure{.kind = base::Outcome::usage,
                                       .why = fmt::format("there is no deck '{}'", word),
                                       .hint = base::suggest_spelling(word, names)};
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

void write_costs(const fs::path& folder, const std::vector<ListedDeck>& decks,
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
      text += fmt::format("{},{:.2g},{:.2g}\n", deck.name, cost->cpu,
                          static_cast<double>(cost->memory) / bytes_of_MB);
    }
  }
  base::write_atomically(folder / costs_name, text);
}

} // namespace spricka::program
