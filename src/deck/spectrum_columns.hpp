// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "deck/context.hpp"

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace spricka::deck {

/// A cycle as the columns of a line have it.
struct CycleOfColumns {
  double low = 0.0, high = 0.0; ///< as they are called: low may lie above high
  double count = 1.0;
  bool high_first = false; ///< the columns name the high end before the other one
};

/// What the columns of a spectrum's lines are: key ORDER of $SPECTRUM.
class SpectrumColumns {
public:
  /// Reads the key; its mistakes are reported. Without it lines are low high count, or turning
  /// points one after another.
  SpectrumColumns(DeckContext& context, const CheckedCard& card);

  [[nodiscard]] bool sound() const { return sound_; }
  /// Whether every number of a line is a load, however many there are.
  [[nodiscard]] bool any_number() const { return columns_.empty(); }
  [[nodiscard]] std::size_t count() const { return columns_.size(); }
  /// "MAX, MIN, COUNT"
  [[nodiscard]] std::string text() const;
  /// Whether the lines hold loads in their order rather than cycles.
  [[nodiscard]] bool has_loads() const;

  /// The loads of a line of so many numbers, appended.
  void append_loads(std::span<const double> numbers, std::vector<double>& loads) const;
  /// The cycle of a line; empty: its two numbers do not make one (R = 1).
  [[nodiscard]] std::optional<CycleOfColumns> cycle(std::span<const double> numbers) const;

private:
  enum class Column { skip, low, high, mean, amplitude, range, ratio, count, value };
  static std::optional<Column> column_of(std::string_view word);
  void check_meaning(DeckContext& context, const CheckedCard& card);

  std::vector<Column> columns_;
  std::vector<std::string> words_;
  bool sound_ = true;
};

} // namespace spricka::deck
