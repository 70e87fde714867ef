// SPDX-License-Identifier: GPL-3.0-or-later
#include "results/stress_component.hpp"

#include <array>

namespace spricka::results {

std::optional<double> stress_component(const Stress& s, std::string_view name) {
  static constexpr std::array<std::string_view, 6> names{"XX", "YY", "ZZ", "XY", "YZ", "XZ"};
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (name == names.at(i)) {
      return s.at(i);
    }
  }
  if (name == "MISES") {
    return von_mises(s);
  }
  if (name == "P1" || name == "P2" || name == "P3") {
    return principal_stresses(s).at(static_cast<std::size_t>(name[1] - '1'));
  }
  return std::nullopt;
}

} // namespace spricka::results
