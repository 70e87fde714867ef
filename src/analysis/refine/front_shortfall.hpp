// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "analysis/refine/wide_bars.hpp"

#include <vector>

/// Error bars along fronts in space against what $TIPNET TOL asks for.
namespace spricka::analysis {

/// As shortfall, of fronts: bars of the points within the body over the largest K of their front.
ToleranceShortfall front_shortfall(const model::Model& model, const results::RunResult& run);

/// By what sizes of each crack's tube and patch are to be divided, so that the part of its bars
/// that the mesh makes comes below what is left of its tolerance. [crack], >= 1
std::vector<double> front_refinement(const model::Model& model, const results::RunResult& run);

} // namespace spricka::analysis
