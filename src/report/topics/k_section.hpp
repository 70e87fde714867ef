// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "model/forward.hpp"
#include "report/topics/figures.hpp"
#include "results/results.hpp"

#include <string>
#include <vector>

namespace spricka::report {

/// K of every step of a run, and what a reader has to know of it.
struct KReportSection {
  std::vector<Figure> pictures; ///< above the tables: K along fronts in space, and the cracks
  /// In space of the last length, front by front. In the plane of one length: one table of all
  /// steps. Several: one of each step whose K is not nothing, the leading step's first, of too many
  /// rows alone.
  std::vector<ReportTable> tables;
  /// Behind a fold K and all that goes with it, in space at every point: the tables have K with its
  /// bars, in space at the places by which a front is reported.
  std::vector<ReportTable> folded;
  std::vector<std::string> remarks; ///< what the tables leave out, and why some K have no bar
  std::vector<Figure> curves;       ///< below: K over the length, in the plane
};
/// Chooses the tables of K for a run by its number of lengths and steps, with the remarks on them.
KReportSection make_k_report_section(const model::Model& model, const results::RunResult& run);

/// For each reason why a K of these steps has no error bar: "No error bar at increments 2 to 7:
/// they are worked out at the first length only ..". Empty where all have one.
std::vector<std::string> missing_error_bar_reasons(const results::RunResult& run,
                                                   const std::vector<std::string>& steps);

} // namespace spricka::report
