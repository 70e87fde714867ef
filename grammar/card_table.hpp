// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "grammar/card_spec.hpp"

/// The two halves of the catalogue and the words its entries are written with.
namespace spricka::grammar {

std::span<const CardSpec> model_cards();    ///< deck, nets, mesh, sets, materials, freedoms
std::span<const CardSpec> analysis_cards(); ///< loads, contact, crack, steps, requests

/// What the help says of a card beyond its table: notes and an example.
struct CardText {
  std::string_view card;
  std::string_view notes;
  std::string_view example;
};
/// Null when the card has none.
const CardText* find_text(std::string_view card);

namespace table {

constexpr Range above(double low) {
  return {low, k_unbounded, true, false};
}
constexpr Range at_least(double low) {
  return {low, k_unbounded, false, false};
}
constexpr Range between(double low, double high) {
  return {low, high, false, false};
}
constexpr Range within(double low, double high) { ///< without the limits themselves
  return {low, high, true, true};
}
constexpr Range anything{};

constexpr KeySpec real(std::string_view name, Quantity quantity, Range range,
                       std::string_view doc) {
  KeySpec key;
  key.name = name;
  key.type = KeyType::real;
  key.quantity = quantity;
  key.range = range;
  key.doc = doc;
  return key;
}

constexpr KeySpec integer(std::string_view name, Range range, std::string_view doc) {
  KeySpec key;
  key.name = name;
  key.type = KeyType::integer;
  key.range = range;
  key.doc = doc;
  return key;
}

constexpr KeySpec word(std::string_view name, std::string_view words, std::string_view doc) {
  KeySpec key;
  key.name = name;
  key.type = KeyType::word;
  key.words = words;
  key.doc = doc;
  return key;
}

constexpr KeySpec of_type(KeyType type, std::string_view name, Kind kind, std::string_view doc) {
  KeySpec key;
  key.name = name;
  key.type = type;
  key.kind = kind;
  key.doc = doc;
  return key;
}

constexpr KeySpec defines(std::string_view name, Kind kind, std::string_view doc) {
  return of_type(KeyType::name, name, kind, doc);
}
constexpr KeySpec refers(std::string_view name, Kind kind, std::string_view doc) {
  return of_type(KeyType::reference, name, kind, doc);
}
constexpr KeySpec text(std::string_view name, std::string_view doc) {
  return of_type(KeyType::text, name, Kind::none, doc);
}
/// A text that names a unit of a quantity.
constexpr KeySpec unit_name(std::string_view name, Quantity quantity, std::string_view doc) {
  KeySpec key = text(name, doc);
  key.quantity = quantity;
  return key;
}
constexpr KeySpec field(std::string_view name, std::string_view doc) {
  return of_type(KeyType::expression, name, Kind::none, doc);
}

constexpr KeySpec required(KeySpec key) {
  key.required = true;
  return key;
}
constexpr KeySpec preset(KeySpec key, std::string_view value) {
  key.default_value = value;
  return key;
}
/// Words (or * for any value) that are understood but have no analysis yet.
constexpr KeySpec later(KeySpec key, std::string_view words) {
  key.later = words;
  return key;
}

} // namespace table
} // namespace spricka::grammar
