// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/sparse.hpp"
#include "base/vec.hpp"
#include "solve/equation_engine.hpp"
#include "solve/factor_report.hpp"
#include "solve/ordering.hpp"
#include "solve/row_elimination.hpp"
#include "solve/unknown_places.hpp"

#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
#include <string>

namespace spricka::solve {

/// How the equations of one net are solved.
struct CondensationSettings {
  OrderingMethod ordering = OrderingMethod::automatic;
  EquationEngine engine = EquationEngine::automatic;
  int threads = 1;          ///< that may work on this net; no bit of a result hangs on it
  double besides = 0.0;     ///< [bytes] what others will need at the same time
  bool out_of_core = false; ///< MUMPS: the factor goes to disk even where it would fit
  /// Where it goes; empty: nowhere. Given by who opens the engine.
  std::string scratch_folder = {};
  /// Columns that will be solved for, where they are few, known beforehand and of a body in space:
  /// then iterations may take less than a factor. 0: do not think of it.
  double solutions = 0.0;
  /// Cholesky: where the factor takes more it is left to others (engine_failed).
  double most_flops = std::numeric_limits<double>::infinity();
  const UnknownPlaces* places = nullptr; ///< of the unknowns; multigrid does nothing without
  /// [n, k] that will be asked for: what iterates is judged by these and keeps their solutions.
  const base::Matrix* loads = nullptr;
  std::string engine_reason = {}; ///< for the report: why it is not Cholesky in core
};

/// External displacements [externals, k] that follow from the condensed loads [externals, k].
using ExternalDisplacementSolver = std::function<base::Matrix(const base::Matrix&)>;

/// The equations K u = f of a net whose last rows are external, solved for its locals by one of the
/// engines. When the status of the report is not ok, nothing else may be asked for.
class CondensedEquations {
public:
  CondensedEquations() = default;
  virtual ~CondensedEquations() = default;
  CondensedEquations(const CondensedEquations&) = delete;
  CondensedEquations& operator=(const CondensedEquations&) = delete;

  [[nodiscard]] virtual const FactorReport& report() const = 0;
  /// The Schur complement S = K_ee - K_el K_ll^-1 K_le [externals, externals], symmetric to the
  /// last bit; once.
  [[nodiscard]] virtual base::Matrix take_schur() = 0;
  /// Loads f [n, k] -> condensed loads f_e - K_el K_ll^-1 f_l [externals, k].
  [[nodiscard]] virtual base::Matrix condense_load(const base::Matrix& f) const = 0;
  /// All unknowns [n, k] of loads f [n, k]: `displacement` is called once, with the condensed
  /// loads.
  [[nodiscard]] virtual base::Matrix
  solve(const base::Matrix& f, const ExternalDisplacementSolver& displacement) const = 0;
  /// F^T K^-1 F [k, k] of columns F [n, k] with the externals held, and F condensed to these.
  [[nodiscard]] virtual RowCompliance
  compliance_with_externals_held(SparseRightHandSides F) const = 0;

  /// All unknowns [n, k] from external displacements [externals, k] and the loads f [n, k].
  [[nodiscard]] base::Matrix recover(const base::Matrix& u_external, const base::Matrix& f) const {
    // What the loads on externals are condensed to is not wanted.
    return solve(f, [&](const base::Matrix&) { return u_external; });
  }
};

} // namespace spricka::solve
