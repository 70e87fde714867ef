// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/units.hpp"
#include "grammar/compile.hpp"
#include "grammar/help.hpp"
#include "grammar/phrases.hpp"

#include <array>
#include <cmath>

#include <nlohmann/json.hpp>

namespace spricka::grammar {

namespace {

using Json = nlohmann::ordered_json;

// In the order of the enumerations KeyType and DataLineForm.
constexpr std::array type_words{"integer",   "real",       "word",     "words", "name",
                                "reference", "references", "integers", "text",  "expression"};
constexpr std::array data_words{"none", "table", "assignments", "rows"};

Json range_of(const ValueLimits& range) {
  Json out = Json::object();
  if (std::isfinite(range.low)) {
    out[range.low_open ? "above" : "minimum"] = range.low;
  }
  if (std::isfinite(range.high)) {
    out[range.high_open ? "below" : "maximum"] = range.high;
  }
  return out;
}

void add_text(Json& out, const char* key, std::string_view text) {
  if (!text.empty()) {
    out[key] = text;
  }
}

Json key_of(const KeySpec& key) {
  Json out;
  out["name"] = key.name;
  out["type"] = type_words[static_cast<std::size_t>(key.type)];
  out["required"] = key.required;
  if (!key.words.empty()) {
    out["words"] = split_words(key.words);
  }
  if (key.kind != EntityKind::none) {
    out["kind"] = display_name(key.kind);
  }
  if (key.type == KeyType::real) {
    out["dimension"] = dimension_formula(key.quantity);
  }
  if (Json range = range_of(key.range); !range.empty()) {
    out["range"] = std::move(range);
  }
  add_text(out, "default", key.default_value);
  add_text(out, "not_in_this_version", key.later);
  out["doc"] = key.doc;
  return out;
}

Json clause_of(const KeyPresenceRule& clause, std::string_view word) {
  Json out;
  out["key"] = clause.key;
  add_text(out, "word", word);
  out["needs"] = split_words(clause.needs);
  out["excludes"] = split_words(clause.forbids);
  return out;
}

Json card_of(const CardSpec& card) {
  Json out;
  out["name"] = card.name;
  out["group"] = card.group;
  out["doc"] = card.doc;
  add_text(out, "notes", card.notes);
  out["once"] = card.once;
  out["available"] = true; // every card of the catalogue has its analysis
  out["data"] = data_words[static_cast<std::size_t>(card.data)];
  out["data_required"] = card.data_required;
  add_text(out, "data_form", card.data_form);
  out["keys"] = Json::array();
  for (const KeySpec& key : card.keys) {
    out["keys"].push_back(key_of(key));
  }
  out["at_most_one_of"] = split_words(card.exclusive);
  out["when"] = Json::array();
  for (const KeyPresenceRule& clause : card.when) {
    const std::vector<std::string> words = split_words(clause.words);
    if (words.empty()) {
      out["when"].push_back(clause_of(clause, {}));
    }
    for (const std::string& word : words) {
      out["when"].push_back(clause_of(clause, word));
    }
  }
  out["example"] = card.example;
  return out;
}

} // namespace

std::string card_catalogue_json() {
  Json out;
  out["language"] = "spricka deck";
  out["version"] = 1;
  for (const CardSpec& card : card_catalogue()) {
    out["cards"].push_back(card_of(card));
  }
  for (const ResultQuantity& quantity : result_quantities()) {
    out["quantities"].push_back({{"name", quantity.name},
                                 {"form", result_call_syntax(quantity)},
                                 {"dimension", dimension_formula(quantity.quantity)},
                                 {"doc", quantity.doc}});
  }
  for (const ExpressionFunctionText& function : expression_functions()) {
    out["functions"].push_back(
        {{"name", function.name}, {"form", function.form}, {"doc", function.doc}});
  }
  out["constants"] = {"PI"};
  out["variables"] = {"X", "Y", "Z", "RHO", "THETA"};
  for (const base::NamedUnit& word : base::unit_words()) {
    const base::PhysicalDimension& d = word.unit.dimension;
    out["units"].push_back({{"name", word.name},
                            {"si", word.unit.si},
                            {"length", d.length},
                            {"force", d.force},
                            {"angle", d.angle}});
  }
  return out.dump(2) + '\n';
}

} // namespace spricka::grammar
