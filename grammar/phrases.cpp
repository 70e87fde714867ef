// SPDX-License-Identifier: GPL-3.0-or-later
#include "grammar/phrases.hpp"

#include <algorithm>
#include <array>
#include <iterator>
#include <utility>

#include <fmt/format.h>

namespace spricka::grammar {

namespace {

// "A", "A and B", "A, B and C".
std::string enumerate(const std::vector<std::string>& words, std::string_view last = "and") {
  std::string out;
  for (std::size_t i = 0; i < words.size(); ++i) {
    const bool final = i > 0 && i + 1 == words.size();
    out += i == 0 ? "" : final ? fmt::format(" {} ", last) : ", ";
    out += words[i];
  }
  return out;
}

std::string number_phrase(std::string_view what, const ValueLimits& range) {
  const std::string limits = range.text();
  return limits.empty() ? std::string(what) : fmt::format("{} {}", what, limits);
}

std::string_view article(std::string_view word) {
  return std::string_view("aeiou").find(word.front()) == std::string_view::npos ? "a" : "an";
}

std::string sentence(const KeyPresenceRule& clause) {
  const std::vector<std::string> needs = split_words(clause.needs);
  const std::vector<std::string> forbids = split_words(clause.forbids);
  std::string out(clause.key);
  out += clause.words.empty() ? "" : fmt::format("={}", clause.words);
  if (!needs.empty()) {
    out += " needs " + enumerate(needs);
  }
  if (!forbids.empty()) {
    out += fmt::format("{} excludes {}", needs.empty() ? "" : " and", enumerate(forbids));
  }
  return out + '.';
}

constexpr std::array<std::pair<std::string_view, std::string_view>, 9> group_texts{{
    {"deck", "units, parameters, included files, the end of the deck"},
    {"subnets", "each net is the mesh of one part, with its own numbers and sets"},
    {"topology", "nodes, elements and sets, written in the deck, generated or imported"},
    {"material and geometry", "what the elements are made of"},
    {"freedoms", "supports, ties and planes of symmetry"},
    {"loads", "load cases, and the steps that apply them"},
    {"contact", "contact surfaces and fits"},
    {"crack", "cracks, the mesh at their tips, their growth"},
    {"requests", "results, checks, numerics, repeated runs"},
}};

// The name of a number among the arguments of a result: a coordinate, an angle or the length.
std::string number_name(const ResultQuantity& quantity, std::size_t before, bool optional) {
  if (optional && quantity.name.starts_with("TEST.")) {
    return before == 0 ? "from" : "to";
  }
  if (optional) {
    return before == 0 ? "a" : "angle";
  }
  if (quantity.name == "PATH.K1.SUM") {
    return before == 0 ? "x" : "y";
  }
  if (quantity.name.ends_with(".PHI") && quantity.arguments.find('l') == std::string_view::npos) {
    return "phi";
  }
  if (quantity.name.starts_with("PATH.") && quantity.name.ends_with(".PHI")) {
    return before == 0 ? "t" : "phi";
  }
  if (quantity.arguments.starts_with("caaa")) { // a place in space
    return before == 0 ? "x" : before == 1 ? "y" : before == 2 ? "z" : "t";
  }
  if (quantity.name.starts_with("PATH.")) {
    return "t";
  }
  if (quantity.name == "CPRESS.AT" || quantity.name == "SHEAR.AT") {
    return "theta";
  }
  if (quantity.name.starts_with("ARC.PART.")) {
    return "n";
  }
  if (quantity.name.ends_with(".AT") || quantity.name.ends_with(".NEAR")) {
    return before == 0 ? "x" : "y";
  }
  return "a";
}

std::string argument_name(const ResultQuantity& quantity, char letter, std::size_t before,
                          bool optional) {
  if (const ResultArgument* argument = find_argument_by_letter(letter)) {
    return std::string(argument->form);
  }
  return letter == 'z' ? "z" : number_name(quantity, before, optional);
}

} // namespace

std::string describe_key_value(const KeySpec& key) {
  switch (key.type) {
  case KeyType::integer:
    return number_phrase("whole number", key.range);
  case KeyType::integers:
    return number_phrase("whole numbers, with commas", key.range);
  case KeyType::real:
    return number_phrase(dimension_formula(key.quantity), key.range);
  case KeyType::word:
    return std::string(key.words);
  case KeyType::words:
    return fmt::format("{}, with commas", key.words);
  case KeyType::name:
    return fmt::format("new name of {} {}", article(display_name(key.kind)),
                       display_name(key.kind));
  case KeyType::reference:
    return fmt::format("name of {} {}", article(display_name(key.kind)), display_name(key.kind));
  case KeyType::references:
    return fmt::format("names, each of {} {}, with commas", article(display_name(key.kind)),
                       display_name(key.kind));
  case KeyType::text:
    return "'text'";
  case KeyType::expression:
    return "(expression in x y z rho theta)";
  }
  return {};
}

std::string describe_key_requirement(const KeySpec& key) {
  return key.required ? "required" : std::string(key.default_value);
}

std::vector<std::string> card_rule_sentences(const CardSpec& card) {
  std::vector<std::string> out;
  if (!card.exclusive.empty()) {
    out.push_back(
        fmt::format("At most one of {} may be given.", enumerate(split_words(card.exclusive))));
  }
  std::ranges::transform(card.when, std::back_inserter(out), sentence);
  return out;
}

std::string describe_unavailable_values(const CardSpec& card) {
  std::vector<std::string> parts;
  for (const KeySpec& key : card.keys) {
    if (key.later == "*") {
      parts.emplace_back(key.name);
    } else if (key.type == KeyType::word && !key.later.empty()) {
      parts.push_back(fmt::format("{}={}", key.name, key.later));
    } else if (!key.later.empty()) {
      parts.push_back(fmt::format("{}{}", key.name, key.later));
    }
  }
  return enumerate(parts);
}

std::string result_call_syntax(const ResultQuantity& quantity) {
  std::string out = fmt::format("{}(", quantity.name);
  bool optional = false;
  std::size_t numbers = 0;
  std::size_t open = 0;
  std::size_t count = 0;
  for (const char letter : quantity.arguments) {
    if (letter == '?') {
      optional = true;
      numbers = 0;
      continue;
    }
    const std::string name = argument_name(quantity, letter, numbers, optional);
    numbers += letter == 'a' ? 1U : 0U;
    if (letter == 'z') {
      out += fmt::format(" [, {}]", name);
    } else if (optional) {
      out += fmt::format(" [{}{}", count > 0 ? ", " : "", name);
      ++open;
    } else {
      out += fmt::format("{}{}", count > 0 ? ", " : "", name);
    }
    ++count;
  }
  return out + std::string(open, ']') + ")";
}

std::string_view data_lines_heading(const CardSpec& card) {
  return card.data_required ? "Data lines" : "Optional data lines";
}

std::vector<std::string_view> card_groups() {
  std::vector<std::string_view> out;
  out.reserve(group_texts.size());
  for (const auto& [group, text] : group_texts) {
    out.push_back(group);
  }
  return out;
}

std::string_view card_group_purpose(std::string_view group) {
  const auto* const it = std::find_if(group_texts.begin(), group_texts.end(),
                                      [&](const auto& g) { return g.first == group; });
  return it == group_texts.end() ? std::string_view() : it->second;
}

} // namespace spricka::grammar
