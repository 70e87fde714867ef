// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "program/study/study_record.hpp"
#include "report/topics/figures.hpp"

#include <vector>

namespace spricka::program {

/// Error of a group of answers against CPU time, and against freedoms, both logarithmic: a curve
/// for each series, marks for single settings, a dashed line where the reference is no better.
std::vector<report::Figure> study_figures(const Study& study, const GroupVerdict& group);

} // namespace spricka::program
