// SPDX-License-Identifier: GPL-3.0-or-later
#include "grammar/card_spec.hpp"

#include <algorithm>
#include <array>

#include <fmt/format.h>

namespace spricka::grammar {

namespace {

// What a name of each kind is called, in the order of the enumeration.
constexpr std::array<std::string_view, 21> kind_names{"name",
                                                      "node set",
                                                      "element set",
                                                      "face set",
                                                      "node or face set",
                                                      "set",
                                                      "material",
                                                      "net",
                                                      "load case",
                                                      "contact",
                                                      "crack",
                                                      "step",
                                                      "parameter",
                                                      "rigid target",
                                                      "load path",
                                                      "spectrum",
                                                      "load interaction",
                                                      "test",
                                                      "growth law",
                                                      "set or rigid target",
                                                      "solid of the file"};
static_assert(kind_names.size() == static_cast<std::size_t>(EntityKind::solid) + 1);

/// What is said of a quantity: its dimension in length, force and angle, its name and its formula.
struct QuantityWords {
  QuantityKind quantity;
  base::PhysicalDimension dimension;
  std::string_view name;
  std::string_view formula;
};
constexpr std::array<QuantityWords, 10> quantity_words{{
    {QuantityKind::number, {0.0, 0.0, 0.0}, "a plain number", "number"},
    {QuantityKind::length, {1.0, 0.0, 0.0}, "a length", "length"},
    {QuantityKind::area, {2.0, 0.0, 0.0}, "an area", "length^2"},
    {QuantityKind::stress, {-2.0, 1.0, 0.0}, "a stress", "stress"},
    {QuantityKind::angle, {0.0, 0.0, 1.0}, "an angle", "angle"},
    {QuantityKind::stress_intensity, {-1.5, 1.0, 0.0}, "a stress intensity", "stress*length^0.5"},
    {QuantityKind::force, {0.0, 1.0, 0.0}, "a force", "force"},
    {QuantityKind::energy_release, {-1.0, 1.0, 0.0}, "an energy release rate", "force/length"},
    {QuantityKind::energy, {1.0, 1.0, 0.0}, "an energy", "force*length"},
    {QuantityKind::life, {0.0, 0.0, 0.0}, "a number of cycles", "number"},
}};

const QuantityWords& words_for(QuantityKind quantity) {
  return *std::ranges::find(quantity_words, quantity, &QuantityWords::quantity);
}

} // namespace

std::string_view display_name(EntityKind kind) {
  return kind_names[static_cast<std::size_t>(kind)];
}

base::PhysicalDimension quantity_dimension(QuantityKind quantity) {
  return words_for(quantity).dimension;
}

std::string_view display_name(QuantityKind quantity) {
  return words_for(quantity).name;
}

std::string_view dimension_formula(QuantityKind quantity) {
  return words_for(quantity).formula;
}

std::string ValueLimits::text() const {
  if (low == high) {
    return fmt::format("{}", low);
  }
  const bool has_low = low > -k_unbounded;
  const bool has_high = high < k_unbounded;
  if (has_low && has_high) {
    return fmt::format("{}{}..{}{}", low, low_open ? "<" : "", high_open ? "<" : "", high);
  }
  if (has_low) {
    return fmt::format("{}{}", low_open ? ">" : ">=", low);
  }
  return has_high ? fmt::format("{}{}", high_open ? "<" : "<=", high) : std::string();
}

const KeySpec* CardSpec::find(std::string_view key) const {
  const auto it = std::ranges::find(keys, key, &KeySpec::name);
  return it == keys.end() ? nullptr : &*it;
}

std::vector<std::string> split_words(std::string_view words) {
  std::vector<std::string> result;
  while (!words.empty()) {
    const std::size_t end = std::min(words.find_first_of("| "), words.size());
    if (end > 0) {
      result.emplace_back(words.substr(0, end));
    }
    words.remove_prefix(std::min(end + 1, words.size()));
  }
  return result;
}

} // namespace spricka::grammar
