// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/vec.hpp"
#include "results/sensitivity.hpp"

namespace spricka::analysis {

/// One thing that K along fronts depends on: loads, gaps and a part of K that it changes by itself.
struct FrontParameterDerivative {
  results::FrontSensitivity is; ///< without its derivatives
  base::Vector load;            ///< [dim * node] by its value; empty: none
  base::Vector gap;             ///< [table row] by its value; empty: none
  base::Vector direct;          ///< [K] dK by its value with u kept
};

} // namespace spricka::analysis
