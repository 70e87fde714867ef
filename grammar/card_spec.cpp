// SPDX-License-Identifier: GPL-3.0-or-later
#include "grammar/card_spec.hpp"

#include <algorithm>

#include <fmt/format.h>

namespace spricka::grammar {

std::string_view display_name(EntityKind kind) {
  switch (kind) {
  case EntityKind::node_set:
    return "node set";
  case EntityKind::element_set:
    return "element set";
  case EntityKind::face_set:
    return "face set";
  case EntityKind::set:
    return "node or face set";
  case EntityKind::any_set:
    return "set";
  case EntityKind::material:
    return "material";
  case EntityKind::net:
    return "net";
  case EntityKind::load_case:
    return "load case";
  case EntityKind::contact:
    return "contact";
  case EntityKind::crack:
    return "crack";
  case EntityKind::step:
    return "step";
  case EntityKind::parameter:
    return "parameter";
  case EntityKind::rigid:
    return "rigid target";
  case EntityKind::path:
    return "load path";
  case EntityKind::spectrum:
    return "spectrum";
  case EntityKind::test:
    return "test";
  case EntityKind::surface:
    return "set or rigid target";
  case EntityKind::none:
    break;
  }
  return "name";
}

base::Dimension quantity_dimension(Quantity quantity) {
  switch (quantity) {
  case Quantity::length:
    return {1.0, 0.0, 0.0};
  case Quantity::area:
    return {2.0, 0.0, 0.0};
  case Quantity::stress:
    return {-2.0, 1.0, 0.0};
  case Quantity::angle:
    return {0.0, 0.0, 1.0};
  case Quantity::stress_intensity:
    return {-1.5, 1.0, 0.0};
  case Quantity::force:
    return {0.0, 1.0, 0.0};
  case Quantity::energy_release:
    return {-1.0, 1.0, 0.0};
  case Quantity::energy:
    return {1.0, 1.0, 0.0};
  case Quantity::number:
    break;
  }
  return {};
}

std::string_view display_name(Quantity quantity) {
  switch (quantity) {
  case Quantity::length:
    return "a length";
  case Quantity::area:
    return "an area";
  case Quantity::stress:
    return "a stress";
  case Quantity::angle:
    return "an angle";
  case Quantity::stress_intensity:
    return "a stress intensity";
  case Quantity::force:
    return "a force";
  case Quantity::energy_release:
    return "an energy release rate";
  case Quantity::energy:
    return "an energy";
  case Quantity::number:
    break;
  }
  return "a plain number";
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
  const auto it =
      std::find_if(keys.begin(), keys.end(), [&](const KeySpec& k) { return k.name == key; });
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
