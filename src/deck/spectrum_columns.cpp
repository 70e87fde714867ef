// SPDX-License-Identifier: GPL-3.0-or-later
#include "deck/spectrum_columns.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include <fmt/format.h>

namespace spricka::deck {

std::optional<SpectrumColumns::Column> SpectrumColumns::column_of(std::string_view word) {
  constexpr std::array<std::pair<std::string_view, Column>, 14> names{
      {{"SKIP", Column::skip},
       {"MIN", Column::low},
       {"LOW", Column::low},
       {"VALLEY", Column::low},
       {"MAX", Column::high},
       {"HIGH", Column::high},
       {"PEAK", Column::high},
       {"MEAN", Column::mean},
       {"AMPLITUDE", Column::amplitude},
       {"RANGE", Column::range},
       {"RATIO", Column::ratio},
       {"COUNT", Column::count},
       {"CYCLES", Column::count},
       {"VALUE", Column::value}}};
  const auto* const found =
      std::ranges::find(names, word, &std::pair<std::string_view, Column>::first);
  return found == names.end() ? std::nullopt : std::optional(found->second);
}

SpectrumColumns::SpectrumColumns(DeckContext& context, const CheckedCard& card) {
  const CheckedValue* order = card.find("ORDER");
  if (order == nullptr) {
    if (card.key_has_word("TYPE", "BLOCKS")) {
      columns_ = {Column::low, Column::high, Column::count};
      words_ = {"low", "high", "count"};
    }
    return;
  }
  for (const NameReference& word : order->names) {
    if (const std::optional<Column> column = column_of(word.name)) {
      columns_.push_back(*column);
      words_.push_back(word.name);
    }
  }
  check_meaning(context, card);
}

bool SpectrumColumns::has_loads() const {
  return any_number() || std::ranges::find(columns_, Column::value) != columns_.end();
}

std::string SpectrumColumns::text() const {
  std::string all;
  for (const std::string& word : words_) {
    all += (all.empty() ? "" : words_.front() == "low" ? " " : ", ") + word;
  }
  return all;
}

// Two columns make a cycle, but not an amplitude with a range.
void SpectrumColumns::check_meaning(DeckContext& context, const CheckedCard& card) {
  const auto many = [&](Column column) { return std::ranges::count(columns_, column); };
  std::ptrdiff_t ends = 0;
  bool twice = many(Column::count) > 1;
  for (const Column column :
       {Column::low, Column::high, Column::mean, Column::amplitude, Column::range, Column::ratio}) {
    ends += many(column);
    twice = twice || many(column) > 1;
  }
  const bool same = many(Column::amplitude) + many(Column::range) == 2;
  const std::ptrdiff_t values = many(Column::value);
  const bool loads = values > 0 && ends == 0 && many(Column::count) == 0;
  sound_ =
      loads ? card.key_has_word("TYPE", "SEQUENCE") : values == 0 && ends == 2 && !twice && !same;
  if (!sound_) {
    context.error(card.find("ORDER")->span, "E110",
                  fmt::format("ORDER={} does not say what a cycle is", text()),
                  "two of MIN, MAX, MEAN, AMPLITUDE or RANGE, RATIO make a cycle, with COUNT or "
                  "without; of TYPE=SEQUENCE VALUE may stand for each turning point; SKIP leaves a "
                  "column out");
  }
}

void SpectrumColumns::append_loads(std::span<const double> numbers,
                                   std::vector<double>& loads) const {
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    if (any_number() || columns_[i] == Column::value) {
      loads.push_back(numbers[i]);
    }
  }
}

std::optional<CycleOfColumns> SpectrumColumns::cycle(std::span<const double> numbers) const {
  // Each column is an equation a low + b high = c.
  struct Equation {
    double a = 0.0, b = 0.0, c = 0.0;
  };
  std::array<Equation, 2> both;
  std::size_t found = 0;
  CycleOfColumns cycle;
  for (std::size_t i = 0; i < columns_.size(); ++i) {
    const double v = numbers[i];
    switch (columns_[i]) {
    case Column::skip:
    case Column::value:
      continue;
    case Column::count:
      cycle.count = v;
      continue;
    case Column::low:
      both[found] = {1.0, 0.0, v};
      break;
    case Column::high:
      both[found] = {0.0, 1.0, v};
      cycle.high_first = found == 0;
      break;
    case Column::mean:
      both[found] = {0.5, 0.5, v};
      break;
    case Column::amplitude:
      both[found] = {-0.5, 0.5, v};
      break;
    case Column::range:
      both[found] = {-1.0, 1.0, v};
      break;
    case Column::ratio:
      both[found] = {1.0, -v, 0.0};
      break;
    }
    ++found;
  }
  const auto& [p, q] = both;
  const double determinant = p.a * q.b - p.b * q.a;
  if (std::fabs(determinant) < 1e-12) {
    return std::nullopt;
  }
  cycle.low = (p.c * q.b - p.b * q.c) / determinant;
  cycle.high = (p.a * q.c - p.c * q.a) / determinant;
  return cycle;
}

} // namespace spricka::deck
