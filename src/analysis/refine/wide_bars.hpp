// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "model/forward.hpp"
#include "results/results.hpp"

#include <string>
#include <vector>

/// Error bars against what $TIPNET TOL asks for.
namespace spricka::analysis {

/// A front at the end of a step, loaded and of a crack with TOL.
struct FrontWithTolerance {
  const results::CrackLengthResult& increment;
  const results::LoadStepResult& step;
  const results::FrontResult& front;
  base::CrackId crack;
  double K = 0.0;         ///< hypot(K1, K2, K3), the largest along it
  double tolerance = 0.0; ///< TOL, a part of that
};
/// All of a run. They look into it.
std::vector<FrontWithTolerance> fronts_with_tolerance(const model::Model& model,
                                                      const results::RunResult& run);

/// Where error bars stand against TOL.
struct ToleranceShortfall {
  double ratio = 0.0;       ///< largest bar over what is allowed; at most 1: all are inside
  double bar = 0.0;         ///< there, over the largest K of its front
  double wanted = 0.0;      ///< TOL there
  std::string where;        ///< "K1 of C1, step LOAD, a = 10.8", in space ".., point 3"
  bool below_floor = false; ///< some TOL is smaller than the floor of its bar: no mesh helps
  std::string parted;       ///< "C1, step LOAD: .." of a tip with TOL, k_consistency.hpp; or empty
  std::string no_bar;       ///< of a front with TOL: why it has no bar; empty: all have one
};
/// Of the bars of tips and of points within a body.
ToleranceShortfall find_tolerance_shortfall(const model::Model& model,
                                            const results::RunResult& run);

/// One K whose bar is too large.
struct ExcessiveErrorBar {
  FrontWithTolerance at;
  const results::KErrorBar& bar;
  double allowed = 0.0; ///< [stress intensity]
};

/// Of all tips with TOL. They look into `run`.
std::vector<ExcessiveErrorBar> find_excessive_error_bars(const model::Model& model,
                                                         const results::RunResult& run);

} // namespace spricka::analysis
