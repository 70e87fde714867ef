// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "results/results.hpp"

#include <string>
#include <vector>

namespace spricka::sense {

/// One line for each front in space along which G and what K stands for part by more than K's error
/// bar, and by more than on sound meshes: the worst place of its steps and lengths. Ends on the
/// body's surface, where both depend on the mesh, and places where the faces touch do not count.
std::vector<std::string> front_consistency_warnings(const results::RunResult& run);

} // namespace spricka::sense
