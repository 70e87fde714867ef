// SPDX-License-Identifier: GPL-3.0-or-later
#include "solve/multigrid_law.hpp"
#include "base/clock.hpp"
#include "base/memory.hpp"

#include <algorithm>

namespace spricka::solve {

namespace {

// [bytes] for each entry of the lower triangle of K: the blocks of half the matrix, and while the
// levels are made both halves as rows and what the coarser levels are multiplied from.
constexpr double bytes_of_entry = 40.0;
constexpr double kept_bytes_of_entry = 10.0;
// [bytes] for each unknown: prolongations, levels and the vectors of the iteration.
constexpr double bytes_of_unknown = 150.0;
// A cycle goes over the finest matrix five times, over the coarser ones as long as a fifth of that.
constexpr double products_of_cycle = 6.0;
// To 1e-8, of a cube of 1e5 to 1e6 unknowns.
constexpr double usual_iterations = 45.0;
// What the levels take to make, as much as so many solutions.
constexpr double set_up_in_solutions = 0.5;

} // namespace

double flops_of_iteration(double entries) {
  // Of both triangles, the product of the iteration itself added.
  return 4.0 * entries * (products_of_cycle + 1.0);
}

FactorReport estimate_multigrid(const base::SymmetricCsc& pattern, std::int64_t externals,
                                const CondensationSettings& settings,
                                const SparseRightHandSides* rows) {
  const auto n = static_cast<double>(pattern.n);
  const auto e = static_cast<double>(externals);
  const auto entries = static_cast<double>(pattern.row.size());
  FactorReport report;
  report.engine = EquationEngine::multigrid;
  report.engine_reason = settings.engine_reason;
  report.besides = settings.besides;
  report.factor_entries = entries;
  report.memory = bytes_of_entry * entries + bytes_of_unknown * n + 16.0 * e * e;
  report.kept_memory = kept_bytes_of_entry * entries + bytes_of_unknown * n;
  report.memory_left = static_cast<double>(base::process_memory_limit()) -
                       static_cast<double>(base::resident_memory());
  const double solution = usual_iterations * flops_of_iteration(entries);
  // With externals a load is solved for before they move and after.
  const double loads = std::max(1.0, settings.solutions) * (externals > 0 ? 2.0 : 1.0);
  report.flops = solution * (set_up_in_solutions + loads + e);
  if (rows != nullptr) {
    const auto count = static_cast<double>(rows->count());
    report.row_flops = solution * count;
    report.row_memory = 8.0 * (2.0 * n + e * count);
  }
  return report;
}

} // namespace spricka::solve
