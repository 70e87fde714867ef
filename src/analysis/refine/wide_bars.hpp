// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "model/forward.hpp"
#include "results/results.hpp"

#include <string>
#include <vector>

namespace spricka::analysis {

/// Where error bars stand against what $TIPNET TOL asks for.
struct ToleranceShortfall {
  double ratio = 0.0;       ///< largest bar over what is allowed; at most 1: all are inside
  double bar = 0.0;         ///< there, over hypot(K1, K2)
  double wanted = 0.0;      ///< TOL there
  std::string where;        ///< "K1 of C1, step LOAD, a = 10.8"
  bool below_floor = false; ///< some TOL is smaller than the floor of its bar: no mesh helps
  std::string parted;       ///< "C1, step LOAD: .." of a tip with TOL, k_consistency.hpp; or empty
  std::string no_bar;       ///< of a tip with TOL: why it has no bar; empty: all have one
};
ToleranceShortfall shortfall(const model::Model& model, const results::RunResult& run);

/// One K whose bar is too large.
struct ExcessiveErrorBar {
  const results::Increment& increment;
  const results::StepResult& step;
  const results::TipResult& tip;
  const results::KErrorBar& bar;
  int mode = 1;
  base::CrackId crack;
  double allowed = 0.0; ///< [stress intensity]
  double wanted = 0.0;  ///< TOL
};

/// Of all increments, steps and tips with TOL. They look into `run`.
std::vector<ExcessiveErrorBar> wide_error_bars(const model::Model& model,
                                               const results::RunResult& run);

} // namespace spricka::analysis
