// SPDX-License-Identifier: GPL-3.0-or-later
#include "results/stress_component.hpp"

namespace spricka::results {

std::optional<double> stress_component(const Stress& s, std::string_view name) {
  for (std::size_t i = 0; i < stress_component_names.size(); ++i) {
    if (name == stress_component_names.at(i)) {
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
