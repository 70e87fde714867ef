// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "model/forward.hpp"
#include "results/results.hpp"

#include <string>

namespace spricka::report {

/// The joint at its last crack length with what acts on it and its cracks, unloaded, as SVG so wide
/// and high at most [px]; empty without a mesh, and of solids with too many faces.
std::string draw_whole_joint(const model::Model& model, const results::RunResult& run, double width,
                             double height);

} // namespace spricka::report
