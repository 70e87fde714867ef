// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/sparse.hpp"
#include "base/vec.hpp"
#include "engines/multigrid/conjugate_gradients.hpp"
#include "engines/multigrid/external_coupling.hpp"
#include "engines/multigrid/multigrid_preconditioner.hpp"
#include "engines/multigrid/nodal_stiffness.hpp"
#include "engines/multigrid/start_space.hpp"
#include "solve/condensed_equations.hpp"
#include "solve/factor_report.hpp"

#include <cstdint>
#include <mutex>
#include <optional>

namespace spricka::engines {

/// The equations of a net in space by conjugate gradients with multigrid: no factor, so that memory
/// and time grow as the unknowns do, but every column of every right-hand side, and every external,
/// is an iteration of its own. It is for one huge body with few loads.
class MultigridEquations final : public solve::CondensedEquations {
public:
  /// K is moved from, and put back where the status is out_of_memory or engine_failed. The engine
  /// of the settings is not looked at.
  MultigridEquations(base::SymmetricCsc& K, std::int64_t externals,
                     const solve::CondensationSettings& settings);

  [[nodiscard]] const solve::FactorReport& report() const override { return report_; }
  [[nodiscard]] base::Matrix take_schur() override;
  [[nodiscard]] base::Matrix condense_load(const base::Matrix& f) const override;
  /// Throws std::range_error where the iterations do not converge.
  [[nodiscard]] base::Matrix
  solve(const base::Matrix& f,
        const solve::ExternalDisplacementSolver& displacement) const override;
  [[nodiscard]] solve::RowCompliance
  compliance_with_externals_held(solve::SparseRightHandSides F) const override;

private:
  [[nodiscard]] bool is_possible(const base::SymmetricCsc& K,
                                 const solve::CondensationSettings& settings);
  void set_up(base::SymmetricCsc& K, const solve::CondensationSettings& settings);
  void solve_expected_loads(const solve::CondensationSettings& settings);
  void form_schur();
  void give_back(base::SymmetricCsc& K);
  void refuse(const IterationResult& result, const base::Vector& u);

  [[nodiscard]] std::int64_t locals() const { return n_ - externals_; }
  /// K_ll u = b from the u that is given, both nodal.
  IterationResult iterate(const base::Vector& b, const IterationGoal& goal,
                          double& smallest_eigenvalue, base::Vector& u) const;
  /// K_ll^-1 b of locals, to the accuracy that is promised; throws where it is not reached.
  [[nodiscard]] base::Vector solve_locals(const base::Vector& b) const;

  std::int64_t n_ = 0;
  std::int64_t externals_ = 0;
  mutable solve::FactorReport report_;
  base::Matrix S_;
  std::optional<NodalStiffness> K_;
  ExternalCoupling coupling_;
  std::optional<MultigridPreconditioner> multigrid_;
  std::optional<ConjugateGradients> iteration_;
  StartSpace start_;
  double smallest_eigenvalue_ = 1.0; ///< of the preconditioned matrix, as the first loads found it
  mutable std::mutex record_;        ///< of what the report says about solutions
};

} // namespace spricka::engines
