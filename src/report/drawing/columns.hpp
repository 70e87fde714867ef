// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/quantity.hpp"
#include "report/drawing/table.hpp"

#include <fmt/format.h>

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

namespace spricka::report {

/// Records have angles in radians, tables and figures in degrees.
using base::degrees_per_radian;

/// A value as the text of a cell: words as they are, nothing of an empty optional, a number as the
/// format of fmt says; without one six digits, whole numbers in full.
template <class Value> std::string cell_text(const Value& value, const char* form = nullptr) {
  if constexpr (std::is_convertible_v<Value, std::string_view>) {
    return std::string(std::string_view(value));
  } else if constexpr (requires { value.has_value(); }) {
    return value ? cell_text(*value, form) : std::string();
  } else {
    const char* const usual = std::is_integral_v<Value> ? "{}" : "{:.6g}";
    return fmt::format(fmt::runtime(form == nullptr ? usual : form), value);
  }
}

/// A number in units of the deck, or none, as it is written.
template <class Value> auto in_output_unit(const Value& value, const base::OutputUnit& unit) {
  if constexpr (requires { value.has_value(); }) {
    return value ? std::optional(unit.from_deck(*value)) : std::nullopt;
  } else {
    static_assert(std::is_floating_point_v<Value>, "texts and counts have no unit to convert from");
    return unit.from_deck(value);
  }
}

/// What a table or a CSV file shows of rows of one kind: columns in their order, each with its
/// name, unit, value, digits and the rows in which it is empty. A value is a member of Row or a
/// function of it.
template <class Row> class Columns {
public:
  /// A column to the left: names, sentences, and what is more than a number.
  template <class Value>
  Columns& words(std::string name, Value value, std::string unit = {}, const char* form = nullptr) {
    return add({std::move(name), std::move(unit), true}, std::move(value), form);
  }
  /// A column to the right; of texts that hold numbers in that unit already.
  template <class Value>
  Columns& number(std::string name, std::string unit, Value value, const char* form = nullptr) {
    return add({std::move(name), std::move(unit), false}, std::move(value), form);
  }
  /// A column to the right of numbers in units of the deck, which are written in this one.
  template <class Value>
  Columns& number(std::string name, const base::OutputUnit& unit, Value value,
                  const char* form = nullptr) {
    return number(
        std::move(name), unit.name,
        [unit, value = std::move(value)](const Row& row) {
          return in_output_unit(std::invoke(value, row), unit);
        },
        form);
  }
  /// A column of a CSV file: the shortest decimal number that reads back to the same bits, whatever
  /// the locale.
  template <class Value> Columns& exact(std::string name, Value value) {
    return add({std::move(name), {}, false}, std::move(value), "{}");
  }
  /// The same of numbers in units of the deck, which are written in this one.
  template <class Value>
  Columns& exact(std::string name, const base::OutputUnit& unit, Value value) {
    return exact(std::move(name), [unit, value = std::move(value)](const Row& row) {
      return in_output_unit(std::invoke(value, row), unit);
    });
  }
  /// Columns added from now on are empty in rows that do not meet the condition.
  Columns& fill_only_if(std::function<bool(const Row&)> condition) {
    condition_ = std::move(condition);
    return *this;
  }
  /// The texts of one row, one for each column.
  [[nodiscard]] std::vector<std::string> cells(const Row& row) const {
    std::vector<std::string> cells;
    for (const auto& text : texts_) {
      cells.push_back(text(row));
    }
    return cells;
  }
  /// The table of these rows.
  template <class Rows> [[nodiscard]] ReportTable table(std::string title, Rows&& rows) const {
    ReportTable table{std::move(title), heads_, {}};
    for (const auto& row : rows) {
      table.rows.push_back(cells(row));
    }
    return table;
  }
  /// The file of these rows: a line "# units: ..", the names, a line for each row.
  template <class Rows>
  [[nodiscard]] std::string csv(std::string_view units, const Rows& rows) const {
    std::string text = fmt::format("# units: {}\n", units);
    for (const ReportTable::ReportColumn& head : heads_) {
      (text += &head == heads_.data() ? "" : ",") += head.name;
    }
    text += '\n';
    for (const auto& row : rows) {
      text += fmt::format("{}\n", fmt::join(cells(row), ","));
    }
    return text;
  }

private:
  template <class Value>
  Columns& add(ReportTable::ReportColumn head, Value value, const char* form) {
    heads_.push_back(std::move(head));
    texts_.push_back([value = std::move(value), form, condition = condition_](const Row& row) {
      return condition && !condition(row) ? std::string()
                                          : cell_text(std::invoke(value, row), form);
    });
    return *this;
  }

  std::vector<ReportTable::ReportColumn> heads_;
  std::vector<std::function<std::string(const Row&)>> texts_;
  std::function<bool(const Row&)> condition_;
};

} // namespace spricka::report
