// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/units.hpp"
#include "grammar/compile.hpp"
#include "grammar/help.hpp"
#include "grammar/phrases.hpp"

#include <fmt/format.h>

namespace spricka::grammar {

namespace {

// A bar would end the cell.
std::string cell(std::string_view text) {
  std::string out;
  for (const char c : text) {
    out += c == '|' ? "\\|" : std::string(1, c);
  }
  return out;
}

std::string code(std::string_view text) {
  return text.empty() ? "" : fmt::format("`{}`", cell(text));
}

std::string anchor(std::string_view name) {
  std::string out;
  for (const char c : name) {
    out += c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  }
  return out;
}

std::string keys(const CardSpec& card) {
  std::string out = "| key | value | default | meaning |\n|---|---|---|---|\n";
  for (const KeySpec& key : card.keys) {
    const std::string value =
        key.type == KeyType::word ? code(key.words) : cell(describe_key_value(key));
    const std::string need = key.required ? "required" : code(key.default_value);
    out += fmt::format("| `{}` | {} | {} | {} |\n", key.name, value, need, cell(key.doc));
  }
  return out + '\n';
}

std::string card_section(const CardSpec& card) {
  std::string out = fmt::format("### ${}\n\n{}", card.name, card.doc);
  out += card.once ? " At most once in a deck.\n\n" : "\n\n";
  out += card.notes.empty() ? "" : fmt::format("{}\n\n", card.notes);
  out += card.keys.empty() ? "" : keys(card);
  const std::vector<std::string> rules = card_rule_sentences(card);
  for (const std::string& rule : rules) {
    out += fmt::format("- {}\n", rule);
  }
  out += rules.empty() ? "" : "\n";
  if (card.data != DataLineForm::none) {
    out += fmt::format("{}: `{}`\n\n", data_lines_heading(card), card.data_form);
  }
  if (const std::string later = describe_unavailable_values(card); !later.empty()) {
    out += fmt::format("Read and checked, but not available in this version: {}.\n\n", code(later));
  }
  return out + fmt::format("```deck\n{}```\n\n", card.example);
}

std::string contents() {
  std::string out;
  for (const std::string_view group : card_groups()) {
    out += fmt::format("- **{}** ({}):", group, card_group_purpose(group));
    for (const CardSpec& card : card_catalogue()) {
      if (card.group == group) {
        out += fmt::format(" [`${}`](#{})", card.name, anchor(card.name));
      }
    }
    out += '\n';
  }
  return out + "- [results](#results), [functions](#functions), [units](#units)\n\n";
}

std::string results() {
  std::string out = "## Results\n\nWhat `$CHECK` can name; `[ ]` may be left out. `a` is a crack "
                    "length of `$GROW`; without it\nthe value is that of the last length.\n\n"
                    "| result | dimension | meaning |\n|---|---|---|\n";
  for (const ResultQuantity& quantity : result_quantities()) {
    out += fmt::format("| {} | {} | {} |\n", code(result_call_syntax(quantity)),
                       dimension_formula(quantity.quantity), quantity.doc);
  }
  return out + '\n';
}

std::string words() {
  std::string out = "## Functions\n\n| function | value |\n|---|---|\n";
  for (const ExpressionFunctionText& function : expression_functions()) {
    out += fmt::format("| `{}` | {} |\n", function.form, function.doc);
  }
  out +=
      "\nThe constant `pi`; in WHERE, ORDER and the values of `$LOAD` also the place: `x y z` and "
      "`rho theta`\n(cylindrical about z).\n\n## Units\n\n";
  for (const base::NamedUnit& word : base::unit_words()) {
    out += fmt::format("`{}` ", word.name);
  }
  return out + "with `*`, `/` and `^`, in `[ ]` behind a number or a bracket.\n";
}

} // namespace

std::string card_reference_markdown() {
  std::string out = "# The cards\n\nThis page has every card of the deck language, with its "
                    "keys, their values and defaults, and an example. Look here\nwhile you write "
                    "or read a deck. To learn the language, begin with [a first "
                    "deck](first_deck.md).\n\nA card is `$` and its name, then keys `KEY=VALUE`; "
                    "data lines may stand below it. `!` starts a comment, and upper\nand lower "
                    "case are the same. `spricka help CARD` prints one card on the terminal. "
                    "This page is made from the\nprogram's own catalogue by `spricka help "
                    "--markdown`; do not edit it. The cards by group:\n\n";
  out += contents();
  for (const std::string_view group : card_groups()) {
    out += fmt::format("## {}: {}\n\n", group, card_group_purpose(group));
    for (const CardSpec& card : card_catalogue()) {
      out += card.group == group ? card_section(card) : "";
    }
  }
  return out + results() + words();
}

} // namespace spricka::grammar
