// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "results/results.hpp"

#include <cstddef>

namespace spricka::report {

/// Number of the step of a length that a reader is to see first: the one with the largest K1 of all
/// fronts, away from surfaces; without cracks that with the most strain energy. The length has
/// steps.
std::size_t find_start_step(const results::CrackLengthResult& increment);

} // namespace spricka::report
