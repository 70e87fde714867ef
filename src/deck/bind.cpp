// SPDX-License-Identifier: GPL-3.0-or-later
#include "deck/bind.hpp"

#include "grammar/parse.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <fmt/format.h>

namespace spricka::deck {

namespace {

using grammar::CardField;
using grammar::KeySpec;
using grammar::KeyType;

// Units of a quantity as they may be written.
std::string_view units_hint(grammar::QuantityKind quantity) {
  switch (quantity) {
  case grammar::QuantityKind::stress_intensity:
    return "'MPa*m^0.5', 'MPa*sqrt(m)', 'ksi*in^0.5', without blanks";
  case grammar::QuantityKind::length:
    return "'mm', 'm', 'in'";
  case grammar::QuantityKind::force:
    return "'N', 'kN', 'lbf', 'kip'";
  case grammar::QuantityKind::stress:
    return "'MPa', 'Pa', 'psi', 'ksi'";
  default:
    return {};
  }
}

/// Checks one value against its key.
class ValueBinder {
public:
  ValueBinder(const KeySpec& key, const grammar::ExpressionScope& scope,
              base::Diagnostics& diagnostics)
      : key_(key), scope_(scope), diagnostics_(diagnostics) {}

  bool bind(const grammar::HeaderParameter& parameter, CheckedValue& value) {
    const bool list = key_.type == KeyType::references || key_.type == KeyType::integers ||
                      key_.type == KeyType::words;
    if (!list && parameter.values.size() > 1) {
      const CardField& second = parameter.values[1];
      const bool digits = parameter.values[0].kind == CardField::CardFieldKind::number &&
                          second.kind == CardField::CardFieldKind::number;
      return fail(second.span, "E108", fmt::format("{}: one value is expected", key_.name),
                  digits ? "the decimal sign is a point" : "");
    }
    bool ok = true;
    for (const CardField& field : parameter.values) {
      ok = one(field, value) && ok;
    }
    return ok;
  }

private:
  bool one(const CardField& field, CheckedValue& value) {
    switch (key_.type) {
    case KeyType::integer:
    case KeyType::real:
    case KeyType::integers:
      return number(field, value);
    case KeyType::word:
    case KeyType::words:
      return word(field, value);
    case KeyType::name:
    case KeyType::reference:
    case KeyType::references:
      return name(field, value);
    case KeyType::text:
      if (field.kind != CardField::CardFieldKind::text) {
        return fail(field.span, "E108", fmt::format("{}: a text is expected", key_.name),
                    fmt::format("write {}='...'", key_.name));
      }
      value.text = field.text;
      return key_.quantity == grammar::QuantityKind::number || unit(field);
    case KeyType::expression:
      return expression(field, value);
    }
    return false;
  }

  bool number(const CardField& field, CheckedValue& value) {
    const bool whole = key_.type != KeyType::real;
    const std::string what = fmt::format("{}: a {}number", key_.name, whole ? "whole " : "");
    const auto found = key_.any_unit
                           ? read_field_number_of_any_kind(field, what, scope_, diagnostics_)
                           : read_field_number(field, key_.quantity, what, scope_, diagnostics_);
    if (!found) {
      return false;
    }
    if (whole && (*found != std::floor(*found) ||
                  std::abs(*found) > std::numeric_limits<std::int32_t>::max())) {
      return fail(field.span, "E108",
                  fmt::format("{}: a whole number is expected, not {}", key_.name, *found));
    }
    if (!key_.range.contains(*found)) {
      return fail(field.span, "E109", fmt::format("{}: {} is out of range", key_.name, *found),
                  fmt::format("{} is {}{}", key_.name, key_.range.text(),
                              key_.quantity == grammar::QuantityKind::angle
                                  ? ", in radians; degrees are written 45[deg]"
                                  : ""));
    }
    value.with_unit = grammar::has_unit(field.expression, scope_);
    if (key_.any_unit) {
      const base::SourceSpan unit =
          grammar::explicit_or_parameter_unit_span(field.expression, scope_);
      value.text = unit.valid() ? scope_.sources->text(unit) : std::string_view();
    }
    value.number = *found;
    value.numbers.push_back(*found);
    return true;
  }

  // A text that names a unit of the key's quantity.
  bool unit(const CardField& field) {
    const auto known = base::parse_unit(field.text);
    const std::string hint(units_hint(key_.quantity));
    if (!known) {
      return fail(field.span, "E204", fmt::format("{}: '{}' is not a unit", key_.name, field.text),
                  key_.quantity == grammar::QuantityKind::stress_intensity
                      ? hint
                      : "m mm um in, N kN MN lbf kip, Pa kPa MPa GPa psi ksi, cycle, with * / ^");
    }
    if (known->dimension != grammar::quantity_dimension(key_.quantity)) {
      return fail(field.span, "E205",
                  fmt::format("{}: '{}' is not the unit of {}", key_.name, field.text,
                              grammar::display_name(key_.quantity)),
                  hint);
    }
    return true;
  }

  bool word(const CardField& field, CheckedValue& value) {
    const std::vector<std::string> valid = grammar::split_words(key_.words);
    const std::string given =
        field.is_name() ? field.text : std::string(scope_.sources->text(field.span));
    if (!field.is_name() || std::ranges::find(valid, given) == valid.end()) {
      const std::string near = base::make_spelling_hint(given, valid);
      return fail(field.span, "E108",
                  fmt::format("{}: '{}' is not one of {}", key_.name,
                              scope_.sources->text(field.span), key_.words),
                  near.starts_with("one of") ? "" : near);
    }
    value.text = given;
    value.names.push_back({given, field.span, {}});
    return true;
  }

  bool name(const CardField& field, CheckedValue& value) {
    if (!field.is_name()) {
      return fail(field.span, "E108", fmt::format("{}: a name is expected", key_.name));
    }
    if (key_.type == KeyType::name && field.text.find('.') != std::string::npos) {
      return fail(field.span, "E108", fmt::format("{}: a new name has no point", key_.name),
                  "the net's name is put in front of it by itself");
    }
    value.text = field.text;
    value.names.push_back({field.text, field.span, {}});
    return true;
  }

  bool expression(const CardField& field, CheckedValue& value) {
    if (!field.is_number_or_expression()) {
      return fail(field.span, "E108",
                  fmt::format("{}: an expression in parentheses is expected", key_.name),
                  fmt::format("write {}=(...) with x y z rho theta", key_.name));
    }
    auto compiled = grammar::compile_expression(field.expression, scope_,
                                                grammar::AllowedVariables::position, diagnostics_);
    if (!compiled) {
      return false;
    }
    if (key_.name == "WHERE" && !grammar::is_condition(field.expression)) {
      return fail(field.span, "E108", "WHERE: a condition is expected", "as in (x > 0 and y < 1)");
    }
    value.expression = std::move(*compiled);
    return true;
  }

  bool fail(base::SourceSpan span, std::string code, std::string text, std::string hint = {}) {
    diagnostics_.error(span, std::move(code), std::move(text), std::move(hint));
    return false;
  }

  const KeySpec& key_;
  const grammar::ExpressionScope& scope_;
  base::Diagnostics& diagnostics_;
};

/// Binds the keys of one card; what was seen and what failed is known to the later checks.
class CardBinder {
public:
  CardBinder(const grammar::CardHeader& card, const grammar::CardSpec& spec,
             const grammar::ExpressionScope& scope, base::Diagnostics& diagnostics)
      : card_(card), spec_(spec), scope_(scope), diagnostics_(diagnostics) {
    bound_.spec = &spec;
    bound_.bad = card.bad;
    bound_.span = card.name_span;
    bound_.data = card.data;
  }

  CheckedCard run() {
    for (const grammar::HeaderParameter& p : card_.parameters) {
      parameter(p);
    }
    if (!card_.bad) { // what the bad part of a header would have said is not known
      missing();
      exclusive();
      when();
    }
    defaults();
    return std::move(bound_);
  }

private:
  void parameter(const grammar::HeaderParameter& p) {
    const KeySpec* key = spec_.find(p.key);
    if (key == nullptr) {
      std::vector<std::string> valid;
      for (const KeySpec& k : spec_.keys) {
        valid.emplace_back(k.name);
      }
      fail(p.key_span, "E105",
           valid.empty() ? fmt::format("${} takes no keys", spec_.name)
                         : fmt::format("${} has no key '{}'", spec_.name, p.key),
           base::make_spelling_hint(p.key, valid));
      for (const CardField& field : p.values) {
        bound_.stray.push_back(field.text);
      }
      return;
    }
    if (const CheckedValue* before = bound_.find(p.key); before != nullptr) {
      fail(p.key_span, "E107", fmt::format("{} is given twice", p.key));
      return;
    }
    CheckedValue value;
    value.key = key;
    value.given = true;
    value.span = p.span;
    if (!ValueBinder(*key, scope_, diagnostics_).bind(p, value)) {
      bound_.bad = true;
      value.sound = false;
    }
    bound_.values.push_back(std::move(value));
  }

  void missing() {
    for (const KeySpec& key : spec_.keys) {
      if (key.required && !bound_.has_key(key.name)) {
        fail(card_.name_span, "E106", fmt::format("${} needs {}", spec_.name, key.name),
             example(key));
      }
    }
  }

  static std::string example(const KeySpec& key) {
    return key.words.empty() ? fmt::format("{}: {}", key.name, key.doc)
                             : fmt::format("{}={}: {}", key.name, key.words, key.doc);
  }

  void exclusive() {
    const CheckedValue* first = nullptr;
    for (const std::string& name : grammar::split_words(spec_.exclusive)) {
      if (!bound_.has_key(name)) {
        continue;
      }
      const CheckedValue* value = bound_.find(name);
      if (first != nullptr) {
        fail(value->span, "E110", fmt::format("{} excludes {}", first->key->name, name),
             fmt::format("at most one of {}",
                         fmt::join(grammar::split_words(spec_.exclusive), ", ")));
      }
      first = first == nullptr ? value : first;
    }
  }

  void when() {
    for (const grammar::KeyPresenceRule& clause : spec_.when) {
      const std::vector<std::string> words = grammar::split_words(clause.words);
      const std::string_view word = bound_.word_value(clause.key);
      if (words.empty() ? !bound_.has_key(clause.key)
                        : std::ranges::find(words, word) == words.end()) {
        continue;
      }
      const std::string where =
          words.empty() ? std::string(clause.key) : fmt::format("{}={}", clause.key, word);
      for (const std::string& name : grammar::split_words(clause.needs)) {
        if (!bound_.has_key(name)) {
          fail(card_.name_span, "E106", fmt::format("${} {} needs {}", spec_.name, where, name),
               example(*spec_.find(name)));
        }
      }
      for (const std::string& name : grammar::split_words(clause.forbids)) {
        if (bound_.has_key(name)) {
          fail(bound_.find(name)->span, "E110",
               fmt::format("{} means nothing with {}", name, where));
        }
      }
    }
  }

  void defaults() {
    for (const KeySpec& key : spec_.keys) {
      if (key.default_value.empty() || bound_.find(key.name) != nullptr) {
        continue;
      }
      CheckedValue value;
      value.key = &key;
      value.span = card_.name_span;
      if (key.type == KeyType::word) {
        value.text = key.default_value;
      } else {
        base::SourceTexts own; // the catalogue's text, read as the deck would be
        const std::int32_t file = own.add_text("catalogue", std::string(key.default_value));
        const base::SourceSpan all{file, 0, static_cast<std::uint32_t>(key.default_value.size())};
        base::Diagnostics none;
        grammar::ExpressionScope constants;
        constants.sources = &own;
        const auto parsed = grammar::parse_expression(own, all, none);
        value.number = grammar::evaluate_constant(parsed.value(), constants, none).value();
      }
      bound_.values.push_back(std::move(value));
    }
  }

  void fail(base::SourceSpan span, std::string code, std::string text, std::string hint = {}) {
    bound_.bad = true;
    diagnostics_.error(span, std::move(code), std::move(text), std::move(hint));
  }

  const grammar::CardHeader& card_;
  const grammar::CardSpec& spec_;
  const grammar::ExpressionScope& scope_;
  base::Diagnostics& diagnostics_;
  CheckedCard bound_;
};

} // namespace

const CheckedValue* CheckedCard::find(std::string_view key) const {
  const auto it =
      std::ranges::find_if(values, [&](const CheckedValue& v) { return v.key->name == key; });
  return it == values.end() ? nullptr : &*it;
}

std::optional<double> CheckedCard::optional_number(std::string_view key) const {
  const CheckedValue* value = find(key);
  return value == nullptr ? std::nullopt : std::optional(value->number);
}

NameReference CheckedCard::name_reference(std::string_view key) const {
  const CheckedValue* value = find(key);
  return value == nullptr ? NameReference{{}, span, net}
                          : NameReference{value->text, value->span, net};
}

CheckedCard check_card_header(const grammar::CardHeader& card, const grammar::CardSpec& spec,
                              const grammar::ExpressionScope& scope,
                              base::Diagnostics& diagnostics) {
  return CardBinder(card, spec, scope, diagnostics).run();
}

std::optional<double> read_field_number_of_any_kind(const grammar::CardField& field,
                                                    std::string_view what,
                                                    const grammar::ExpressionScope& scope,
                                                    base::Diagnostics& diagnostics) {
  if (!field.is_number_or_expression()) {
    const std::string_view written = scope.sources->text(field.span);
    const bool parameter = field.is_name() && scope.values.contains(field.text);
    const bool call = field.kind == CardField::CardFieldKind::quantity;
    const std::vector<grammar::ExpressionFunctionText> functions = grammar::expression_functions();
    const bool known = std::ranges::find(functions, field.text,
                                         &grammar::ExpressionFunctionText::name) != functions.end();
    diagnostics.error(field.span, "E108", fmt::format("{} is expected", what),
                      parameter ? fmt::format("write ({}) for the value of the parameter", written)
                      : !call   ? ""
                      : known   ? fmt::format("an expression stands in parentheses: ({})", written)
                                : grammar::unknown_function_hint(field.text));
    return std::nullopt;
  }
  return grammar::evaluate_constant(field.expression, scope, diagnostics);
}

std::optional<double> read_field_number(const grammar::CardField& field,
                                        grammar::QuantityKind quantity, std::string_view what,
                                        const grammar::ExpressionScope& scope,
                                        base::Diagnostics& diagnostics) {
  const auto value = read_field_number_of_any_kind(field, what, scope, diagnostics);
  const bool fits = value && check_field_unit(field, grammar::quantity_dimension(quantity),
                                              fmt::format("is not the unit of {}",
                                                          grammar::display_name(quantity)),
                                              scope, diagnostics);
  return fits ? value : std::nullopt;
}

bool check_field_unit(const grammar::CardField& field, const base::PhysicalDimension& dimension,
                      std::string_view complaint, const grammar::ExpressionScope& scope,
                      base::Diagnostics& diagnostics) {
  const base::SourceSpan unit = grammar::explicit_or_parameter_unit_span(field.expression, scope);
  const auto known = unit.valid() ? base::parse_unit(scope.sources->text(unit)) : std::nullopt;
  if (!known || known->dimension == dimension) {
    return true;
  }
  const bool written_here = grammar::explicit_unit_span(field.expression).valid();
  diagnostics.error(written_here ? unit : field.span, "E205",
                    fmt::format("'{}' {}", scope.sources->text(unit), complaint),
                    written_here ? "" : "the parameter is given in this unit");
  return false;
}

} // namespace spricka::deck
