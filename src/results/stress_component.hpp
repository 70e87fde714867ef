// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "results/stress_invariants.hpp"

#include <array>
#include <optional>
#include <string_view>

namespace spricka::results {

/// Names of the components of Stress, in its order.
inline constexpr std::array<std::string_view, 6> stress_component_names{"XX", "YY", "ZZ",
                                                                        "XY", "YZ", "XZ"};
/// Names of principal stresses, the largest first.
inline constexpr std::array<std::string_view, 3> principal_stress_names{"P1", "P2", "P3"};

/// XX YY ZZ XY YZ XZ, MISES, or a principal stress P1 P2 P3; empty: there is no such component.
std::optional<double> stress_component(const Stress& s, std::string_view name);

} // namespace spricka::results
