// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "contact/system.hpp"
#include "solve/held_rows.hpp"

#include <vector>

namespace spricka::contact {

/// Displacements, openings and loads on the modes of bodies under loads, without contact forces.
struct ResponseWithoutContact {
  std::vector<base::Matrix> u; ///< [body][m, k] external displacements
  base::Matrix opening;        ///< [row, k]
  base::Matrix on_mode;        ///< [mode, k]
};
/// The response to condensed loads [body][m, k].
ResponseWithoutContact response_without_contact(const ContactSystem& system,
                                                const std::vector<base::Matrix>& load);

/// What condensed loads [body][m, k] come to on the rigid modes of the bodies. [mode, k]
base::Matrix loads_on_rigid_modes(const ContactSystem& system,
                                  const std::vector<base::Matrix>& load);

/// What forces of the rows [row, k] open these by, rigid modes at rest. [row, k]
base::Matrix openings_by_forces(const ContactSystem& system, const base::Matrix& force);

/// A contact system with some rows held at zero gap, whatever the sign of their forces, and all
/// others away: linear, factorised once.
class FixedActiveSet {
public:
  /// `system` must outlive it; `rows` of the system, each once.
  FixedActiveSet(const ContactSystem& system, std::vector<std::size_t> rows);

  [[nodiscard]] const std::vector<std::size_t>& held_rows() const { return rows_; }
  [[nodiscard]] bool is_consistent() const {
    return held_.is_solvable();
  } ///< false: the rows contradict each other

  struct ActiveSetResponse {
    base::Matrix force;     ///< [row, k] zero where not held
    base::Matrix mode;      ///< [mode, k]
    double left_over = 0.0; ///< largest load on motions that open no held row: they rest
  };
  /// The response to gaps of all rows before they press [row, k] and loads on the modes [mode, k].
  [[nodiscard]] ActiveSetResponse solve_response(const base::Matrix& gap,
                                                 const base::Matrix& on_mode) const;
  /// The gaps of all rows [row, k] after a response to gaps before.
  [[nodiscard]] base::Matrix gaps_after(const base::Matrix& gap,
                                        const ActiveSetResponse& response) const;
  /// The largest load on modes [mode, k] that no held row takes: they would move without bound.
  [[nodiscard]] double unheld_load(const base::Matrix& on_mode) const;
  /// Pivots of single rows of the system [candidate]: of a row that is not held the gap that a unit
  /// of its own force opens, of a held one the force that a unit of its gap takes (manual,
  /// solve.29). Zero where there is none: redundant rows. Only where is_consistent().
  [[nodiscard]] base::Vector row_pivots(const std::vector<std::size_t>& candidates) const;

private:
  const ContactSystem& system_;
  std::vector<std::size_t> rows_;
  solve::ClosedRowsSolver held_;
};

/// External displacements [body][m, k] under the loads of a response without contact and what held
/// rows answer, of each column its own.
std::vector<base::Matrix> external_displacements(const ContactSystem& system,
                                                 const ResponseWithoutContact& free,
                                                 const FixedActiveSet::ActiveSetResponse& response);

} // namespace spricka::contact
