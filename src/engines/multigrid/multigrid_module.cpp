// SPDX-License-Identifier: GPL-3.0-or-later
#include "engines/multigrid/multigrid_equations.hpp"
#include "solve/engine_exports.hpp"
#include "solve/engine_module.hpp"
#include "solve/multigrid_law.hpp"

const char* spricka_engine_abi() {
  return spricka::solve::engine_abi();
}

spricka::solve::CondensedEquations*
spricka_condense_equations(spricka::base::SymmetricCsc* K, std::int64_t externals,
                           const spricka::solve::CondensationSettings* settings) {
  return new spricka::engines::MultigridEquations(*K, externals, *settings);
}

void spricka_forecast_equations(spricka::base::SymmetricCsc* pattern, std::int64_t externals,
                                const spricka::solve::CondensationSettings* settings,
                                const spricka::solve::SparseRightHandSides* rows,
                                spricka::solve::FactorReport* report) {
  *report = spricka::solve::estimate_multigrid(*pattern, externals, *settings, rows);
}
