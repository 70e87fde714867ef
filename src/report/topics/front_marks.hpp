// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "report/topics/figures.hpp"

#include <vector>

namespace spricka::report {

/// A figure for each crack in space that has grown by a law: its fronts at all stations.
std::vector<Figure> beach_mark_figures(const model::Model& model, const results::RunResult& run);

} // namespace spricka::report
