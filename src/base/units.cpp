// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/units.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include <fmt/format.h>

namespace spricka::base {

namespace {

constexpr double newton_per_lbf = 4.4482216152605;
constexpr double metre_per_inch = 0.0254;

constexpr PhysicalDimension length_dimension{1.0, 0.0, 0.0};
constexpr PhysicalDimension force_dimension{0.0, 1.0, 0.0};
constexpr PhysicalDimension stress_dimension{-2.0, 1.0, 0.0};
constexpr PhysicalDimension angle_dimension{0.0, 0.0, 1.0};

constexpr std::array<NamedUnit, 18> words{{
    {"m", {1.0, length_dimension}},
    {"mm", {1e-3, length_dimension}},
    {"um", {1e-6, length_dimension}},
    {"in", {metre_per_inch, length_dimension}},
    {"N", {1.0, force_dimension}},
    {"kN", {1e3, force_dimension}},
    {"MN", {1e6, force_dimension}},
    {"lbf", {newton_per_lbf, force_dimension}},
    {"kip", {1e3 * newton_per_lbf, force_dimension}},
    {"Pa", {1.0, stress_dimension}},
    {"kPa", {1e3, stress_dimension}},
    {"MPa", {1e6, stress_dimension}},
    {"GPa", {1e9, stress_dimension}},
    {"psi", {newton_per_lbf / (metre_per_inch * metre_per_inch), stress_dimension}},
    {"ksi", {1e3 * newton_per_lbf / (metre_per_inch * metre_per_inch), stress_dimension}},
    {"deg", {std::numbers::pi / 180.0, angle_dimension}},
    {"rad", {1.0, angle_dimension}},
    {"cycle", {1.0, {}}}, // a count
}};

const PhysicalUnit* find_word(std::string_view name) {
  const auto* const it =
      std::find_if(words.begin(), words.end(), [&](const NamedUnit& w) { return w.name == name; });
  return it == words.end() ? nullptr : &it->unit;
}

bool is_letter(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
}

// value * base^exponent. Small bases go through their reciprocal, which is a whole number for the
// metric prefixes, so that the usual factors come out exact.
double scaled(double value, double base, double exponent) {
  if (base < 1.0) {
    base = 1.0 / base;
    exponent = -exponent;
  }
  return exponent < 0.0 ? value / std::pow(base, -exponent) : value * std::pow(base, exponent);
}

// Unit factors are short decimal numbers; this takes away what the powers left of rounding.
double tidied(double factor) {
  const std::string text = fmt::format("{:.12g}", factor);
  double shorter = 0.0;
  std::from_chars(text.data(), text.data() + text.size(), shorter);
  const double rounding = 4.0 * std::numeric_limits<double>::epsilon() * std::abs(factor);
  return std::abs(shorter - factor) <= rounding ? shorter : factor;
}

// "MPa*m^0.5" of "MPa*sqrt(m)".
std::string with_roots_as_powers(std::string_view text) {
  std::string out(text);
  constexpr std::string_view root = "sqrt(";
  for (std::size_t at = out.find(root); at != std::string::npos; at = out.find(root)) {
    const std::size_t end = out.find(')', at);
    out.replace(end, 1, "^0.5");
    out.erase(at, root.size());
  }
  return out;
}

// One `word [^exponent]` or `sqrt(word)`, taken off the front of `text`; multiplied onto `unit`
// with the sign of `direction`.
bool take_term(std::string_view& text, double direction, PhysicalUnit& unit) {
  const bool root = text.starts_with("sqrt(");
  text.remove_prefix(root ? 5 : 0);
  const auto stop = std::find_if_not(text.begin(), text.end(), is_letter);
  const auto length = static_cast<std::size_t>(stop - text.begin());
  const PhysicalUnit* word = find_word(text.substr(0, length));
  if (word == nullptr) {
    return false;
  }
  text.remove_prefix(length);
  if (root && !text.starts_with(')')) {
    return false;
  }
  text.remove_prefix(root ? 1 : 0);
  double exponent = root ? 0.5 : 1.0;
  if (!root && text.starts_with('^')) {
    text.remove_prefix(text.starts_with("^+") ? 2 : 1);
    const auto [end, failure] =
        std::from_chars(text.data(), text.data() + text.size(), exponent, std::chars_format::fixed);
    if (failure != std::errc{} || !std::isfinite(exponent) || std::abs(exponent) > 12.0) {
      return false;
    }
    text.remove_prefix(static_cast<std::size_t>(end - text.data()));
  }
  exponent *= direction;
  unit.si = scaled(unit.si, word->si, exponent);
  unit.dimension.length += exponent * word->dimension.length;
  unit.dimension.force += exponent * word->dimension.force;
  unit.dimension.angle += exponent * word->dimension.angle;
  return true;
}

bool same_word(std::string_view a, std::string_view upper_case) {
  return std::equal(a.begin(), a.end(), upper_case.begin(), upper_case.end(), [](char x, char y) {
    return (x >= 'a' && x <= 'z' ? static_cast<char>(x - 'a' + 'A') : x) == y;
  });
}

} // namespace

std::vector<NamedUnit> unit_words() {
  return {words.begin(), words.end()};
}

std::string UnitSystem::stress_name() const {
  if (force_name == "N" && length_name == "mm") {
    return "MPa";
  }
  if (force_name == "N" && length_name == "m") {
    return "Pa";
  }
  if (force_name == "kN" && length_name == "mm") {
    return "GPa";
  }
  if (force_name == "kN" && length_name == "m") {
    return "kPa";
  }
  if (force_name == "lbf" && length_name == "in") {
    return "psi";
  }
  return fmt::format("{}/{}^2", force_name, length_name);
}

std::string UnitSystem::stress_intensity_name() const {
  return fmt::format("{}*{}^0.5", stress_name(), length_name);
}

OutputUnit UnitSystem::output_length() const {
  return output.length.value_or(OutputUnit{length_name});
}

OutputUnit UnitSystem::output_force() const {
  return output.force.value_or(OutputUnit{force_name});
}

OutputUnit UnitSystem::output_stress() const {
  return output.stress.value_or(OutputUnit{stress_name()});
}

OutputUnit UnitSystem::output_stress_intensity() const {
  return output.stress_intensity.value_or(OutputUnit{stress_intensity_name()});
}

std::optional<PhysicalUnit> parse_unit(std::string_view text) {
  PhysicalUnit unit;
  if (!take_term(text, 1.0, unit)) {
    return std::nullopt;
  }
  while (!text.empty()) {
    const char op = text.front();
    text.remove_prefix(1);
    if ((op != '*' && op != '/') || !take_term(text, op == '*' ? 1.0 : -1.0, unit)) {
      return std::nullopt;
    }
  }
  return unit;
}

double factor_to_deck_units(const PhysicalUnit& unit, const UnitSystem& system) {
  const double lengths = scaled(unit.si, system.metre_per_length, -unit.dimension.length);
  return tidied(scaled(lengths, system.newton_per_force, -unit.dimension.force));
}

std::optional<OutputUnit> make_output_unit(std::string_view text, const UnitSystem& system) {
  const std::optional<PhysicalUnit> known = parse_unit(text);
  if (!known) {
    return std::nullopt;
  }
  OutputUnit unit{with_roots_as_powers(text)};
  const double deck_units = factor_to_deck_units(*known, system);
  (deck_units < 1.0 ? unit.multiplier : unit.divisor) =
      deck_units < 1.0 ? tidied(1.0 / deck_units) : deck_units;
  return unit;
}

std::optional<UnitSystem> make_unit_system(std::string_view length, std::string_view force) {
  UnitSystem system;
  constexpr std::array<std::pair<std::string_view, std::string_view>, 3> lengths{
      {{"M", "m"}, {"MM", "mm"}, {"IN", "in"}}};
  constexpr std::array<std::pair<std::string_view, std::string_view>, 3> forces{
      {{"N", "N"}, {"KN", "kN"}, {"LBF", "lbf"}}};
  const auto* const l = std::find_if(lengths.begin(), lengths.end(),
                                     [&](const auto& w) { return same_word(length, w.first); });
  const auto* const f = std::find_if(forces.begin(), forces.end(),
                                     [&](const auto& w) { return same_word(force, w.first); });
  if (l == lengths.end() || f == forces.end()) {
    return std::nullopt;
  }
  system.length_name = l->second;
  system.force_name = f->second;
  system.metre_per_length = find_word(l->second)->si;
  system.newton_per_force = find_word(f->second)->si;
  return system;
}

} // namespace spricka::base
