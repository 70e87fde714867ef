// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "grammar/card_spec.hpp"

#include <algorithm>
#include <array>

/// The parts of the catalogue and the words its entries are written with.
namespace spricka::grammar {

std::span<const CardSpec> model_cards();    ///< deck, nets, mesh, sets, materials, freedoms
std::span<const CardSpec> joint_cards();    ///< loads, contact, crack
std::span<const CardSpec> analysis_cards(); ///< steps, growth, requests

/// What the help says of a card beyond its table: notes and an example.
struct CardHelpText {
  std::string_view card;
  std::string_view notes;
  std::string_view example;
};
/// Null when the card has none.
const CardHelpText* find_card_help(std::string_view card);

namespace table {

/// Limits of numbers larger than `low`, which is excluded.
constexpr ValueLimits above(double low) {
  return {low, k_unbounded, true, false};
}
/// Limits of numbers from `low` on, which is included.
constexpr ValueLimits at_least(double low) {
  return {low, k_unbounded, false, false};
}
/// Limits of numbers between two, both included.
constexpr ValueLimits closed_interval(double low, double high) {
  return {low, high, false, false};
}
constexpr ValueLimits open_interval(double low, double high) { ///< without the limits themselves
  return {low, high, true, true};
}
constexpr ValueLimits anything{};

/// A key with a real number, whose unit is that of a quantity.
constexpr KeySpec real_key(std::string_view name, QuantityKind quantity, ValueLimits range,
                           std::string_view doc) {
  KeySpec key;
  key.name = name;
  key.type = KeyType::real;
  key.quantity = quantity;
  key.range = range;
  key.doc = doc;
  return key;
}

/// A key with a whole number within limits.
constexpr KeySpec integer_key(std::string_view name, ValueLimits range, std::string_view doc) {
  KeySpec key;
  key.name = name;
  key.type = KeyType::integer;
  key.range = range;
  key.doc = doc;
  return key;
}

/// A key with one of the words "A|B|C".
constexpr KeySpec word_key(std::string_view name, std::string_view words, std::string_view doc) {
  KeySpec key;
  key.name = name;
  key.type = KeyType::word;
  key.words = words;
  key.doc = doc;
  return key;
}

/// A key with a list of the words "A|B|C".
constexpr KeySpec words_key(std::string_view name, std::string_view words, std::string_view doc) {
  KeySpec key = word_key(name, words, doc);
  key.type = KeyType::words;
  return key;
}

/// A key with a number that may have a unit of any kind.
constexpr KeySpec any_number_key(std::string_view name, ValueLimits range, std::string_view doc) {
  KeySpec key = real_key(name, QuantityKind::number, range, doc);
  key.any_unit = true;
  return key;
}

/// A key of a type that deals with names of a kind, or with none.
constexpr KeySpec key_of_type(KeyType type, std::string_view name, EntityKind kind,
                              std::string_view doc) {
  KeySpec key;
  key.name = name;
  key.type = type;
  key.kind = kind;
  key.doc = doc;
  return key;
}

/// A key whose value becomes the name of what the card defines.
constexpr KeySpec defining_key(std::string_view name, EntityKind kind, std::string_view doc) {
  return key_of_type(KeyType::name, name, kind, doc);
}
/// A key that refers to a name which another card defines.
constexpr KeySpec reference_key(std::string_view name, EntityKind kind, std::string_view doc) {
  return key_of_type(KeyType::reference, name, kind, doc);
}
/// A key with a text between quotes.
constexpr KeySpec text_key(std::string_view name, std::string_view doc) {
  return key_of_type(KeyType::text, name, EntityKind::none, doc);
}
/// A text that names a unit of a quantity.
constexpr KeySpec unit_key(std::string_view name, QuantityKind quantity, std::string_view doc) {
  KeySpec key = text_key(name, doc);
  key.quantity = quantity;
  return key;
}
/// A key with an expression in the coordinates x y z rho theta.
constexpr KeySpec expression_key(std::string_view name, std::string_view doc) {
  return key_of_type(KeyType::expression, name, EntityKind::none, doc);
}

/// The key as one that the card must have.
constexpr KeySpec required(KeySpec key) {
  key.required = true;
  return key;
}
/// The key with a value, written as in a deck, that holds where none is given.
constexpr KeySpec with_default(KeySpec key, std::string_view value) {
  key.default_value = value;
  return key;
}
/// Words (or * for any value) that are understood but have no analysis yet.
constexpr KeySpec with_unavailable_words(KeySpec key, std::string_view words) {
  key.later = words;
  return key;
}

/// Two lists, one behind the other.
template <class Entry, std::size_t first, std::size_t second>
constexpr std::array<Entry, first + second> join(const std::array<Entry, first>& a,
                                                 const std::array<Entry, second>& b) {
  std::array<Entry, first + second> all{};
  std::ranges::copy(b, std::ranges::copy(a, all.begin()).out);
  return all;
}

} // namespace table
} // namespace spricka::grammar
