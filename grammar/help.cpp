// SPDX-License-Identifier: GPL-3.0-or-later
#include "grammar/help.hpp"

#include "base/units.hpp"
#include "grammar/compile.hpp"
#include "grammar/field_words.hpp"
#include "grammar/phrases.hpp"
#include "grammar/wrap.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include <fmt/format.h>

namespace spricka::grammar {

namespace {

constexpr std::size_t k_body = 2; ///< indentation of paragraphs

std::string key_table(const CardSpec& card, std::size_t width) {
  TextColumns table{{{"key", "value", "default", "meaning"}}, {14, 34, 12, 0}};
  for (const KeySpec& key : card.keys) {
    table.rows.push_back({std::string(key.name), describe_key_value(key),
                          describe_key_requirement(key), std::string(key.doc)});
  }
  return table.format_columns(width);
}

std::string indented(std::string_view text, std::size_t indent) {
  std::string out;
  while (!text.empty()) {
    const std::size_t end = text.find('\n');
    out += std::string(indent, ' ');
    out += text.substr(0, end);
    out += '\n';
    text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
  }
  return out;
}

/// Quantities that units are named for, in terms of m and N.
constexpr std::array<std::pair<QuantityKind, std::string_view>, 4> named_quantities{
    {{QuantityKind::length, " m"},
     {QuantityKind::force, " N"},
     {QuantityKind::stress, " N/m^2"},
     {QuantityKind::angle, " rad"}}};

// "stress" and "1000000 N/m^2" for MPa; a unit of none of these quantities counts.
std::pair<std::string, std::string> kind_and_size(const base::NamedUnit& word) {
  const std::string size = fmt::format("{:.10g}", word.unit.si);
  for (const auto& [quantity, unit] : named_quantities) {
    if (word.unit.dimension == quantity_dimension(quantity)) {
      return {std::string(dimension_formula(quantity)), size + std::string(unit)};
    }
  }
  return {"count", size};
}

} // namespace

std::string card_list_help(std::size_t width) {
  std::string out;
  for (const std::string_view group : card_groups()) {
    out += fmt::format("{}: {}\n", group, card_group_purpose(group));
    TextColumns table{{}, {12, 0}};
    for (const CardSpec& card : card_catalogue()) {
      if (card.group == group) {
        table.rows.push_back({fmt::format("${}", card.name), std::string(card.doc)});
      }
    }
    out += table.format_columns(width) + '\n';
  }
  return out;
}

std::string card_help(const CardSpec& card, std::size_t width) {
  std::string out = fmt::format("${}  ({}{})\n", card.name, card.group,
                                card.once ? ", at most once in a deck" : "");
  out += wrap_paragraph(card.doc, k_body, width);
  if (!card.notes.empty()) {
    out += '\n' + wrap_paragraph(card.notes, k_body, width);
  }
  if (!card.keys.empty()) {
    out += '\n' + key_table(card, width);
  }
  const std::vector<std::string> rules = card_rule_sentences(card);
  out += rules.empty() ? "" : "\n";
  for (const std::string& rule : rules) {
    out += wrap_paragraph(rule, k_body, width);
  }
  out +=
      '\n' + wrap_paragraph(card.data == DataLineForm::none
                                ? fmt::format("${} takes no data lines.", card.name)
                                : fmt::format("{}: {}", data_lines_heading(card), card.data_form),
                            k_body, width);
  if (const std::string later = describe_unavailable_values(card); !later.empty()) {
    out +=
        '\n' + wrap_paragraph(
                   fmt::format("Read and checked, but not available in this version: {}.", later),
                   k_body, width);
  }
  return out + "\nExample:\n" + indented(card.example, k_body);
}

namespace {

// What a key's text says about one of its words, "INCREMENT: the lengths are given"; the whole text
// where it speaks of none, and nothing where it speaks of others only.
std::string about_word(const KeySpec& key, std::string_view word) {
  std::string_view text = key.doc;
  bool of_words = false;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find("; "), text.size());
    const std::string_view part = text.substr(0, end);
    const std::size_t colon = part.find(": ");
    const std::string_view head = part.substr(0, colon == std::string_view::npos ? 0 : colon);
    const std::vector<std::string> words = split_words(key.words);
    if (head == word) {
      return std::string(part.substr(colon + 2));
    }
    of_words = of_words || std::find(words.begin(), words.end(), head) != words.end();
    text.remove_prefix(std::min(end + 2, text.size()));
  }
  return of_words ? std::string() : std::string(key.doc);
}

char small(char c) {
  return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
}

bool has_text(std::string_view text, std::string_view word) {
  return std::search(text.begin(), text.end(), word.begin(), word.end(),
                     [](char a, char b) { return small(a) == small(b); }) != text.end();
}

} // namespace

std::string search_help_texts(std::string_view word, std::size_t width) {
  constexpr std::size_t least = 3; // letters: fewer are everywhere
  TextColumns table{{}, {34, 0}};
  for (const CardSpec& card : card_catalogue()) {
    if (word.size() < least) {
      break;
    }
    if (has_text(card.doc, word) || has_text(card.notes, word) || has_text(card.data_form, word)) {
      table.rows.push_back({fmt::format("${}", card.name), std::string(card.doc)});
    }
    for (const KeySpec& key : card.keys) {
      if (has_text(key.doc, word)) {
        table.rows.push_back({fmt::format("${} {}", card.name, key.name), std::string(key.doc)});
      }
    }
  }
  for (const ResultQuantity& quantity : result_quantities()) {
    if (word.size() >= least && has_text(quantity.doc, word)) {
      table.rows.push_back({result_call_syntax(quantity), std::string(quantity.doc)});
    }
  }
  return table.rows.empty() ? std::string() : table.format_columns(width);
}

std::string language_word_help(std::string_view word, std::size_t width) {
  TextColumns table{{}, {34, 34, 0}};
  for (const CardSpec& card : card_catalogue()) {
    for (const KeySpec& key : card.keys) {
      const std::vector<std::string> words = split_words(key.words);
      const bool value = std::find(words.begin(), words.end(), word) != words.end();
      if (key.name == word || value) {
        table.rows.push_back(
            {fmt::format("${} {}{}{}", card.name, key.name, value ? "=" : "", value ? word : ""),
             value ? std::string() : describe_key_value(key),
             value ? about_word(key, word) : std::string(key.doc)});
      }
    }
  }
  for (const ExpressionFunctionText& function : expression_functions()) {
    if (function.name == word) {
      table.rows.push_back({std::string(function.form), "function", std::string(function.doc)});
    }
  }
  return table.rows.empty() ? std::string() : table.format_columns(width);
}

std::string damage_tolerance_help(std::string_view word, std::size_t width) {
  const DamageToleranceTerm* found = find_damage_tolerance_term(word);
  if (found == nullptr) {
    return {};
  }
  const auto topics = split_words(found->topics);
  const auto pages = split_words(found->pages);
  return wrap_paragraph(fmt::format("{} (also: {})", found->word, found->also), 0, width) +
         wrap_paragraph(found->text, k_body, width) + '\n' +
         wrap_paragraph(fmt::format("More: spricka help {}", fmt::join(topics, ", ")), k_body,
                        width) +
         wrap_paragraph(fmt::format("Manual: {}.md", fmt::join(pages, ".md, ")), k_body, width);
}

std::string list_damage_tolerance_terms(std::size_t width) {
  TextColumns table{{}, {24, 0}};
  for (const DamageToleranceTerm& word : damage_tolerance_terms()) {
    table.rows.push_back({std::string(word.word), std::string(word.also)});
  }
  return "Words of damage tolerance; spricka help WORD says what each one is here:\n" +
         table.format_columns(width);
}

std::string result_quantities_help(std::size_t width, const ResultQuantity* one) {
  std::string out = one != nullptr ? "" : "Results that $CHECK can name; [ ] may be left out:\n";
  TextColumns table{{}, {44, 20, 0}};
  for (const ResultQuantity& quantity : result_quantities()) {
    if (one == nullptr || one == &quantity) {
      table.rows.push_back({result_call_syntax(quantity),
                            std::string(dimension_formula(quantity.quantity)),
                            std::string(quantity.doc)});
    }
  }
  out += table.format_columns(width);
  return out + '\n' +
         wrap_paragraph(
             "a is a crack length of $GROW; without it the value is that of the last length. "
             "A crack with two tips has NAME.1 and NAME.2.",
             k_body, width);
}

std::string functions_help(std::size_t width) {
  std::string out = "Functions of expressions:\n";
  TextColumns table{{}, {14, 0}};
  for (const ExpressionFunctionText& function : expression_functions()) {
    table.rows.push_back({std::string(function.form), std::string(function.doc)});
  }
  out += table.format_columns(width);
  out += "\nNames:\n";
  const TextColumns names{{{"pi", "3.14159.."},
                           {"x y z", "the place, in WHERE, ORDER and the values of $LOAD"},
                           {"rho theta", "the same in cylindrical coordinates about z"}},
                          {14, 0}};
  out += names.format_columns(width);
  out += "\nOperators, the tightest first:\n";
  const TextColumns operators{{{"^", "power, from the right: 2^3^2 = 512"},
                               {"- +", "signs: -2^2 = -4"},
                               {"* /", ""},
                               {"+ -", ""},
                               {"< <= > >= ==", "comparison, 1 or 0"},
                               {"and or", "one level: mix them with brackets"}},
                              {14, 0}};
  return out + operators.format_columns(width);
}

std::string units_help(std::size_t width) {
  std::string out = "Units stand in [ ] behind a number or a bracket:\n";
  TextColumns table{{}, {8, 10, 0}};
  for (const base::NamedUnit& word : base::unit_words()) {
    const auto [kind, size] = kind_and_size(word);
    table.rows.push_back({std::string(word.name), kind, size});
  }
  out += table.format_columns(width);
  return out + '\n' +
         wrap_paragraph(
             "Products, quotients and powers are units too: [MPa*mm^0.5], [N/mm^2]. A number "
             "with a unit is converted into the units of $DECK; a bare one is in them, angles "
             "in radians. Units are written as here: case counts (MN is not mN).",
             k_body, width);
}

} // namespace spricka::grammar
