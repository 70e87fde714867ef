// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/tidy.hpp"

#include <array>
#include <charconv>
#include <cmath>
#include <limits>

#include <fmt/format.h>

namespace spricka::base {

double restore_short_decimal(double value) {
  constexpr double rounding = 16.0 * std::numeric_limits<double>::epsilon();
  constexpr int digits = 12; // with those of the rounding all that a double has
  std::array<char, 40> text{};
  const auto [end, failure] = std::to_chars(text.data(), text.data() + text.size(), value,
                                            std::chars_format::scientific, digits - 1);
  double shorter = value;
  if (failure == std::errc{}) {
    std::from_chars(text.data(), end, shorter);
  }
  return std::abs(shorter - value) <= rounding * std::abs(value) ? shorter : value;
}

std::string format_coordinates(const Vec3& x, int dim, const OutputUnit& unit) {
  const Vec3 written = x.unaryExpr([&](double value) { return unit.from_deck(value); });
  return fmt::format("({:.6g})", fmt::join(written.data(), written.data() + dim, ", "));
}

} // namespace spricka::base
