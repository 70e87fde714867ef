// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "results/load_path.hpp"
#include "solve/parametric.hpp"

/// Functions of the parameter of a load path.
namespace spricka::analysis {

/// Path parameters where the solution changes its slope: the begin of each segment, and the end.
std::vector<double> path_knots(const solve::SolutionPath& found);

/// Functional k of a solution path by its values and slopes on each segment, linear in between.
base::PiecewiseLinear path_functional(const solve::SolutionPath& found, Eigen::Index k);

/// Sets functional K1 of a solution path to 0 on the segments on which the faces of a crack touch
/// at the front, that is on which row `row` of the path's problem is closed; whether there are any.
bool zero_K1_where_closed(const solve::SolutionPath& found, std::size_t row,
                          base::PiecewiseLinear& K1);

/// Warns where K on the path and K of the steps at its ends, which come from the same numbers by
/// different ways, are apart.
void warn_of_K_mismatch(results::LoadPathResult& path);

} // namespace spricka::analysis
