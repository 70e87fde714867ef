// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "analysis/steps/step_solver.hpp"
#include "contact/held_contact.hpp"

#include <array>
#include <optional>
#include <vector>

/// How the contact of a step's end goes on when loads and gaps change at given rates.
namespace spricka::analysis {

/// Loads and gaps per unit of something; condensed as the contact system takes them.
struct LoadAndGapRates {
  std::vector<base::Matrix> load;       ///< [body][m, k]
  contact::ResponseWithoutContact free; ///< to them
  base::Matrix gap;                     ///< [table row, k] that come on top
  base::Vector load_scale;              ///< [k] a typical force
};

/// Contact at the end of a step: rows in force, their forces and gaps.
class FrozenContact {
public:
  /// `solver` has a system and has just solved `state`; nothing rubs.
  FrozenContact(const StepSolver& solver, const Discretisation& scene, const StepState& state);

  /// Whether a force or a gap is so small that rows change sides on one side of this state: below
  /// 1e-8 of the largest.
  [[nodiscard]] bool is_degenerate() const { return weak_ > 0; }

  /// Rows of the table that stay closed when column k of the rates sets in, `sign` +1 or -1:
  /// the small ones choose (the contact problem for the direction; manual, sensitivity.12). Empty:
  /// nothing would hold a body.
  [[nodiscard]] std::optional<std::vector<bool>>
  closed_rows_after(const LoadAndGapRates& rates, Eigen::Index k, double sign) const;

  /// How far each column can go on, down and up, until a row changes (manual, sensitivity.11);
  /// infinite where none does. Small ones do not count. [k]
  [[nodiscard]] std::vector<std::array<double, 2>>
  linear_ranges(const contact::FixedActiveSet& held, const LoadAndGapRates& rates) const;

private:
  struct FrozenContactRow {
    std::size_t row = 0; ///< of the table
    bool equality = false;
    bool closed = false;
    bool weak = false;
    double force = 0.0;
    double gap = 0.0; ///< weighted
  };
  const contact::ContactSystem& system_;
  std::vector<FrozenContactRow> rows_; ///< in force
  int weak_ = 0;
};

} // namespace spricka::analysis
