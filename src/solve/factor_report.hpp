// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <cstdint>

namespace spricka::solve {

enum class FactorStatus { ok, not_positive_definite, out_of_memory };

struct FactorReport {
  FactorStatus status = FactorStatus::ok;
  std::int64_t failed_row = -1; ///< row of the matrix as given where a pivot was not positive
  double flops = 0.0;           ///< of the numeric phase, exact
  double memory = 0.0;          ///< [bytes] forecast of the largest need, from the symbolic phase
  double besides = 0.0;         ///< [bytes] that must be left for others
  double memory_left = 0.0;     ///< [bytes] what could be had when it was begun
  double smallest_pivot = 1.0;  ///< of the locals, over the diagonal entry of the matrix
  double kept_memory = 0.0;     ///< [bytes] of the factor, external part included
  double factor_entries = 0.0;  ///< nonzeros of L
  double analysis_cpu = 0.0;    ///< [s] of the calling thread, as below
  double numeric_cpu = 0.0;     ///< [s]
  double row_flops = 0.0;       ///< forecast for the compliance of contact rows
  double row_memory = 0.0;      ///< [bytes] its workspace
};

} // namespace spricka::solve
