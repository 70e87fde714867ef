// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "results/stress_invariants.hpp"

#include <optional>
#include <string_view>

namespace spricka::results {

/// XX YY ZZ XY YZ XZ, MISES, or a principal stress P1 P2 P3; empty: there is no such component.
std::optional<double> stress_component(const Stress& s, std::string_view name);

} // namespace spricka::results
