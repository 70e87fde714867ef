// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "model/forward.hpp"
#include "report/topics/figures.hpp"
#include "report/topics/k_tables.hpp"
#include "results/results.hpp"

#include <string>
#include <vector>

/// K along the fronts of cracks in space.
namespace spricka::report {

/// K1, K2 and K3 over the angle (of an ellipse) or the length along the front of that name, steps
/// of the increment as curves.
Figure k_along_front_figure(const model::Model& model, const results::CrackLengthResult& increment,
                            const std::string& name);

/// The same of each front at the last increment, and the front in its body.
std::vector<Figure> k_along_front_figures(const model::Model& model, const results::RunResult& run);

/// A figure for each crack in space that has grown by a law: its fronts at all stations.
std::vector<Figure> beach_mark_figures(const model::Model& model, const results::RunResult& run);

} // namespace spricka::report
