// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "program/study/verdict.hpp"

#include <span>
#include <string>

namespace spricka::program {

/// What a plateau is judged by.
struct PlateauContext {
  const GroupVerdict& group; ///< its errors and floor
  const SeriesVerdict& series;
  const std::vector<Trial>& trials;
  const std::vector<Answer>& answers;
  const StudyVerdict& verdict;
};

/// Why errors of a series stop falling, in words: how well the reference is known, what is not made
/// finer with the rest, quarter points that are missing, values at single nodes.
std::string plateau_reason(const PlateauContext& view, std::span<const ConvergencePoint> points);

} // namespace spricka::program
