// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "solve/equation_engine.hpp"

#include <cstdint>
#include <string>

namespace spricka::solve {

/// engine_failed: the engine cannot be had, or was stopped by something other than the matrix: a
/// full disk, a library that is missing.
enum class FactorStatus { ok, not_positive_definite, out_of_memory, engine_failed };

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
  EquationEngine engine = EquationEngine::cholesky; ///< that did it, or would
  bool out_of_core = false;                         ///< its factor is kept on disk
  double disk = 0.0;         ///< [bytes] that the factor takes on disk, forecast
  std::string engine_reason; ///< why it was not Cholesky in core; empty where it was
  std::string trouble;       ///< of an engine that failed: what happened, and what helps
  /// Relative error of a displacement as its residual estimates it; 0: a direct engine within
  /// round-off, or nothing was solved.
  double relative_error = 0.0;
};

} // namespace spricka::solve
