// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/output_unit.hpp"

#include <fmt/format.h>

#include <cmath>

namespace spricka::base {

std::string OutputUnit::text(double value, int digits) const {
  return fmt::format("{:.{}g} {}", from_deck(value), digits, name);
}

OutputUnit operator*(const OutputUnit& a, const OutputUnit& b) {
  return {fmt::format("{}*{}", a.name, b.name), a.multiplier * b.multiplier, a.divisor * b.divisor};
}

OutputUnit operator/(const OutputUnit& a, const OutputUnit& b) {
  return {fmt::format("{}/{}", a.name, b.name), a.multiplier * b.divisor, a.divisor * b.multiplier};
}

OutputUnit raised(const OutputUnit& unit, int exponent) {
  return {fmt::format("{}^{}", unit.name, exponent), std::pow(unit.multiplier, exponent),
          std::pow(unit.divisor, exponent)};
}

} // namespace spricka::base
