// SPDX-License-Identifier: GPL-3.0-or-later
#include "solve/engine_choice.hpp"
#include "solve/sparse_condensation.hpp"

#include <utility>

namespace spricka::solve {

std::unique_ptr<CondensedEquations> condense_equations(base::SymmetricCsc K, std::int64_t externals,
                                                       const CondensationSettings& settings) {
  return std::make_unique<SparseCondensation>(std::move(K), externals, settings);
}

FactorReport forecast_equations(base::SymmetricCsc pattern, std::int64_t externals,
                                const CondensationSettings& settings,
                                const SparseRightHandSides* rows) {
  return SparseCondensation::forecast(std::move(pattern), externals, settings, rows);
}

} // namespace spricka::solve
