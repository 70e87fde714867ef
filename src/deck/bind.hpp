// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/diagnostics.hpp"
#include "base/expression.hpp"
#include "base/id.hpp"
#include "grammar/ast.hpp"
#include "grammar/catalogue.hpp"
#include "grammar/compile.hpp"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace spricka::deck {

/// A name used in a deck: where, and in which net's scope.
struct NameReference {
  std::string name;
  base::SourceSpan span;
  std::string net;
};

/// The value of one key after checking against the catalogue.
struct CheckedValue {
  const grammar::KeySpec* key = nullptr;
  base::SourceSpan span; ///< of the value; of the card for a default
  bool given = false;
  bool sound = true;      ///< false: the value is wrong, and reported
  bool with_unit = false; ///< a unit stands in the number, or in what it is made of
  double number = 0.0;
  std::string text; ///< word, name or text; of a number in any unit that unit, if it has one
  std::vector<NameReference> names; ///< lists of names
  std::vector<double> numbers;      ///< lists of numbers
  base::CompiledExpression expression;
};

/// A card whose header agrees with the catalogue, but for what is missing in a bad one.
struct CheckedCard {
  const grammar::CardSpec* spec = nullptr;
  bool bad = false;      ///< an error in its header: what it defines is poisoned
  bool rows_bad = false; ///< rows with a syntax error, reported, are missing in `rows`
  std::string net;       ///< the open net's name, or empty
  base::NetId net_id;
  base::SourceSpan span; ///< of $NAME
  base::SourceSpan data;
  std::vector<CheckedValue> values;
  std::vector<grammar::DataRow> rows;
  std::vector<std::string> stray; ///< names given under keys the card does not have

  /// The value of a key, given or by default; null where there is neither.
  [[nodiscard]] const CheckedValue* find(std::string_view key) const;
  /// Given in the deck (not by default).
  [[nodiscard]] bool has_key(std::string_view key) const {
    const CheckedValue* value = find(key);
    return value != nullptr && value->given;
  }
  /// Of the value of a key that is given in the deck, else of the card.
  [[nodiscard]] base::SourceSpan value_span(std::string_view key) const {
    return has_key(key) ? find(key)->span : span;
  }
  /// Number of a key that is given or has a default.
  [[nodiscard]] double number_value(std::string_view key) const {
    return optional_number(key).value_or(0.0);
  }
  /// The number of a key as an integer, cut off at the point.
  [[nodiscard]] int integer_value(std::string_view key) const {
    return static_cast<int>(number_value(key));
  }
  /// Number of a key; empty where it is neither given nor has a default.
  [[nodiscard]] std::optional<double> optional_number(std::string_view key) const;
  /// Word, name or text of a key; empty without one.
  [[nodiscard]] std::string_view word_value(std::string_view key) const {
    const CheckedValue* value = find(key);
    return value == nullptr ? std::string_view() : std::string_view(value->text);
  }
  /// Whether the value of a key is this word.
  [[nodiscard]] bool key_has_word(std::string_view key, std::string_view word_) const {
    return word_value(key) == word_;
  }
  /// The name a key refers to, with the net whose sets come first.
  [[nodiscard]] NameReference name_reference(std::string_view key) const;
};

/// Checks a header against its catalogue entry: unknown, missing, double and clashing keys, kinds
/// of values, words, ranges, units. Defaults are filled in. Errors leave the card `bad`.
CheckedCard check_card_header(const grammar::CardHeader& card, const grammar::CardSpec& spec,
                              const grammar::ExpressionScope& scope,
                              base::Diagnostics& diagnostics);

/// Number of a field in a data line: literal or (expr). Empty after an error; `what` is what the
/// message asks for, "a factor".
std::optional<double> read_field_number(const grammar::CardField& field,
                                        grammar::QuantityKind quantity, std::string_view what,
                                        const grammar::ExpressionScope& scope,
                                        base::Diagnostics& diagnostics);

/// The same of a number in whatever unit, in units of the deck.
std::optional<double> read_field_number_of_any_kind(const grammar::CardField& field,
                                                    std::string_view what,
                                                    const grammar::ExpressionScope& scope,
                                                    base::Diagnostics& diagnostics);

/// Whether a field has no unit, or one of a dimension; else that is reported, "'mm' " and the
/// complaint. A unit that is none is left to the evaluation.
bool check_field_unit(const grammar::CardField& field, const base::PhysicalDimension& dimension,
                      std::string_view complaint, const grammar::ExpressionScope& scope,
                      base::Diagnostics& diagnostics);

} // namespace spricka::deck
