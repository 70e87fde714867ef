// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/sparse.hpp"
#include "base/vec.hpp"
#include "engines/mumps/mumps_elimination.hpp"
#include "engines/mumps/mumps_instance.hpp"
#include "solve/condensed_equations.hpp"
#include "solve/factor_report.hpp"

#include <cstdint>
#include <mutex>
#include <optional>

namespace spricka::engines {

/// The equations of a net by MUMPS (Amestoy, Duff, L'Excellent and Koster 2001): the locals are
/// eliminated front by front in our own order, the externals are its Schur complement, so that a
/// floating body needs no support. In core, or with the factor on disk where memory is short.
class MumpsCondensation final : public solve::CondensedEquations {
public:
  /// K is moved from; where the status is out_of_memory or engine_failed it is given back if it
  /// could be. The engine of the settings is not looked at. With `step`, on rank 0, all ranks of
  /// the run do it together.
  MumpsCondensation(base::SymmetricCsc& K, std::int64_t externals,
                    const solve::CondensationSettings& settings, solve::CollectiveStep step = {});
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
  void fail(MumpsInstance::Failure failure);
  void keep_external_stiffness(const base::SymmetricCsc& K);
  [[nodiscard]] std::int64_t local_count() const { return n_ - externals_; }
  [[nodiscard]] double solution_flops(std::int64_t columns) const {
    return 4.0 * report_.factor_entries * static_cast<double>(columns);
  }

  std::int64_t externals_ = 0;
  solve::CollectiveStep step_;
  std::int64_t n_ = 0;
  mutable solve::FactorReport report_; ///< with what the last rows took
  base::Matrix S_;
  mutable std::mutex in_use_; ///< from the elimination of right-hand sides to their solution
  mutable std::optional<MumpsElimination> locals_; ///< empty where there are none
};

} // namespace spricka::engines
