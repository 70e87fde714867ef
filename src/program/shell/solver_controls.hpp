// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/equation_engines.hpp"
#include "model/forward.hpp"

#include <functional>

namespace spricka::program {

/// What solvers may take of the machine.
struct SolverThreadsAndStop {
  std::function<int(const model::Model&)> threads;                 ///< empty: one
  std::function<base::EquationEngine(const model::Model&)> engine; ///< empty: automatic
  std::function<bool()> stopped;                                   ///< may be empty
};

} // namespace spricka::program
