// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/inp_elements.hpp"

#include <algorithm>
#include <array>
#include <span>
#include <utility>

namespace spricka::mesh {
namespace {

using base::ElementType;
using model::StressState;

struct InpElementFamily {
  std::string_view prefix;
  StressState state;
};
constexpr std::array<InpElementFamily, 4> families{{{"CPS", StressState::plane_stress},
                                                    {"CPE", StressState::plane_strain},
                                                    {"CAX", StressState::axisymmetric},
                                                    {"C3D", StressState::solid}}};

using Count = std::pair<std::string_view, ElementType>;
constexpr std::array<Count, 4> plane{{{"3", ElementType::trim3},
                                      {"4", ElementType::quam4},
                                      {"6", ElementType::trimc6},
                                      {"8", ElementType::quamc8}}};
constexpr std::array<Count, 6> solid{{{"4", ElementType::tet4},
                                      {"6", ElementType::penta6},
                                      {"8", ElementType::hexe8},
                                      {"10", ElementType::tet10},
                                      {"15", ElementType::pentac15},
                                      {"20", ElementType::hexec20}}};

/// Forms with the same nodes: reduced integration, incompatible modes, hybrid, modified.
constexpr std::array<std::string_view, 7> special{"R", "I", "H", "RH", "IH", "M", "MH"};

std::span<const Count> counts(StressState state) {
  return state == StressState::solid ? std::span<const Count>(solid)
                                     : std::span<const Count>(plane);
}

} // namespace

std::optional<InpElementType> find_inp_element_type(std::string_view name) {
  for (const InpElementFamily& family : families) {
    if (!name.starts_with(family.prefix)) {
      continue;
    }
    const std::string_view rest = name.substr(family.prefix.size());
    const std::size_t digits = std::min(rest.find_first_not_of("0123456789"), rest.size());
    for (const auto& [count, type] : counts(family.state)) {
      const std::string_view suffix = rest.substr(digits);
      const bool known = std::find(special.begin(), special.end(), suffix) != special.end();
      if (rest.substr(0, digits) == count && (suffix.empty() || known)) {
        return InpElementType{type, family.state, known};
      }
    }
  }
  return std::nullopt;
}

std::string inp_element_name(ElementType type, StressState state) {
  const auto* const family =
      std::find_if(families.begin(), families.end(),
                   [&](const InpElementFamily& f) { return f.state == state; });
  for (const auto& [count, counted] : counts(state)) {
    if (counted == type) {
      return std::string(family->prefix) + std::string(count);
    }
  }
  return {};
}

} // namespace spricka::mesh
