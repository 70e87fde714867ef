// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/sparse.hpp"
#include "base/vec.hpp"
#include "engines/mumps/mumps_instance.hpp"
#include "engines/mumps/mumps_matrix.hpp"
#include "solve/condensed_equations.hpp"
#include "solve/factor_report.hpp"

#include <cstdint>
#include <mutex>
#include <optional>
#include <vector>

namespace spricka::engines {

/// The equations of a net by MUMPS (Amestoy, Duff, L'Excellent and Koster 2001): the locals are
/// eliminated front by front in our own order, the externals are its Schur complement, so that a
/// floating body needs no support. In core, or with the factor on disk where memory is short.
class MumpsCondensation final : public solve::CondensedEquations {
public:
  /// K is moved from; where the status is out_of_memory or engine_failed it is given back if it
  /// could be. The engine of the settings is not looked at.
  MumpsCondensation(base::SymmetricCsc& K, std::int64_t externals,
                    const solve::CondensationSettings& settings);
  /// As solve::forecast_equations. The pattern is moved from.
  static solve::FactorReport forecast(base::SymmetricCsc& pattern, std::int64_t externals,
                                      const solve::CondensationSettings& settings,
                                      const solve::SparseRightHandSides* rows);

  [[nodiscard]] const solve::FactorReport& report() const override { return report_; }
  [[nodiscard]] base::Matrix take_schur() override;
  [[nodiscard]] base::Matrix condense_load(const base::Matrix& f) const override;
  [[nodiscard]] base::Matrix
  solve(const base::Matrix& f,
        const solve::ExternalDisplacementSolver& displacement) const override;
  [[nodiscard]] solve::RowCompliance
  compliance_with_externals_held(solve::SparseRightHandSides F) const override;

private:
  explicit MumpsCondensation(std::int64_t externals) : externals_(externals) {}
  void analyse(base::SymmetricCsc& K, const solve::CondensationSettings& settings);
  void choose_where_the_factor_goes(const solve::CondensationSettings& settings);
  [[nodiscard]] bool find_room_on_disk(const solve::CondensationSettings& settings);
  void factorise();
  void check_pivots();
  [[nodiscard]] std::int64_t loosest_row() const;
  void estimate_error();
  void fail(MumpsInstance::Failure failure);
  void keep_external_stiffness(const base::SymmetricCsc& K);

  [[nodiscard]] std::int64_t locals() const { return n_ - externals_; }
  /// Columns of right-hand sides that are solved at a time.
  [[nodiscard]] std::int64_t block_width(std::int64_t columns) const;
  /// X [n, k], scaled loads: eliminates the locals; what is left for the externals [externals, k].
  /// Without externals X becomes the solution.
  base::Matrix eliminate(base::Matrix& X) const;
  /// X [n, k] becomes the locals of what was eliminated last, the externals displaced as given.
  void back_substitute(const base::Matrix& u_external, base::Matrix& X) const;
  void ask(int what, base::Matrix& X, base::Matrix& external) const;
  void run_solution() const;

  std::int64_t externals_ = 0;
  std::int64_t n_ = 0;
  solve::FactorReport report_;
  base::Matrix S_;
  std::optional<MumpsMatrix> K_;
  mutable std::mutex in_use_; ///< from the elimination of right-hand sides to their solution
  mutable std::optional<MumpsInstance> mumps_;
  std::vector<int> order_, external_rows_; ///< as MUMPS wants them, counted from 1
};

} // namespace spricka::engines
