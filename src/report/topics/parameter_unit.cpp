// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/topics/parameter_unit.hpp"

#include <algorithm>
#include <cctype>
#include <string_view>

namespace spricka::report {
namespace {

char upper(char c) {
  return static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
}

std::string_view trimmed(std::string_view text) {
  const std::size_t from = text.find_first_not_of(" \t\r");
  return from == std::string_view::npos
             ? std::string_view()
             : text.substr(from, text.find_last_not_of(" \t\r") + 1 - from);
}

/// What is between [ and ] where a line reads `name = number[unit]`, else empty.
std::string_view unit_in(std::string_view line, std::string_view name) {
  line = line.substr(0, line.find('!'));
  const std::size_t equals = line.find('=');
  if (equals == std::string_view::npos) {
    return {};
  }
  const std::string_view value = trimmed(line.substr(equals + 1));
  const std::size_t open = value.find('[');
  const bool named = std::ranges::equal(trimmed(line.substr(0, equals)), name, {}, upper, upper);
  const bool number =
      value.substr(0, open).find_first_not_of("0123456789.+-eE ") == std::string_view::npos;
  if (!named || !number || open == std::string_view::npos || !value.ends_with(']')) {
    return {};
  }
  return value.substr(open + 1, value.size() - open - 2);
}

std::string name_of(const base::PhysicalDimension& dimension, const base::UnitSystem& system) {
  if (dimension == base::PhysicalDimension{1.0, 0.0, 0.0}) {
    return system.length_name;
  }
  if (dimension == base::PhysicalDimension{0.0, 1.0, 0.0}) {
    return system.force_name;
  }
  if (dimension == base::PhysicalDimension{0.0, 0.0, 1.0}) {
    return "rad";
  }
  if (dimension == base::PhysicalDimension{-2.0, 1.0, 0.0}) {
    return system.stress_name();
  }
  return dimension == base::PhysicalDimension{-1.5, 1.0, 0.0} ? system.stress_intensity_name() : "";
}

} // namespace

std::string find_parameter_unit(const base::SourceTexts& sources, const base::UnitSystem& system,
                                const std::string& name) {
  for (std::int32_t f = 0; f < static_cast<std::int32_t>(sources.count()); ++f) {
    std::string_view text = sources.text(f);
    while (!text.empty()) {
      const std::size_t end = std::min(text.find('\n'), text.size());
      const std::string_view unit = unit_in(text.substr(0, end), name);
      if (const auto found = unit.empty() ? std::nullopt : base::parse_unit(unit)) {
        return name_of(found->dimension, system);
      }
      text.remove_prefix(std::min(end + 1, text.size()));
    }
  }
  return {};
}

} // namespace spricka::report
