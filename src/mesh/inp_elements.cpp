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

/// Forms with the same nodes: reduced integration, incompatible modes, hybrid, modified, with
/// stresses at the surface, with temperatures or pore pressures as further unknowns.
constexpr std::array<std::string_view, 20> special{"R",   "I", "H",  "RH", "IH",  "M",   "MH",
                                                   "HS",  "S", "T",  "RT", "HT",  "RHT", "MT",
                                                   "MHT", "P", "RP", "PH", "RPH", "MP"};

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

std::optional<InpSurfaceElementType> find_inp_surface_element_type(std::string_view name) {
  static constexpr std::array<std::string_view, 5> plates{"SFM3D", "STRI", "M3D", "R3D", "S"};
  if (name == "T2D2" || name == "T3D2" || name == "T2D3" || name == "T3D3") {
    return InpSurfaceElementType{2, static_cast<std::size_t>(name.back() - '0')};
  }
  for (const std::string_view prefix : plates) {
    if (!name.starts_with(prefix)) {
      continue;
    }
    const std::string_view count = name.substr(prefix.size(), 1); // S8R5, STRI65
    if (count == "3" || count == "6") {
      return InpSurfaceElementType{3, count == "3" ? 3U : 6U};
    }
    if (count == "4" || count == "8" || count == "9") {
      return InpSurfaceElementType{4, static_cast<std::size_t>(count[0] - '0')};
    }
  }
  return std::nullopt;
}

bool is_inp_connector(std::string_view name) {
  static constexpr std::array<std::string_view, 10> begins{
      "SPRING", "DASHPOT", "MASS", "ROTARYI", "GAP", "DCOUP", "CONN", "JOINT", "HEATCAP", "ITT"};
  return std::ranges::any_of(begins,
                             [&](std::string_view begin) { return name.starts_with(begin); });
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
