// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "contact/system.hpp"
#include "solve/held_rows.hpp"

#include <vector>

namespace spricka::contact {

/// A contact system with some rows held at zero gap, whatever the sign of their forces, and all
/// others away: linear, factorised once.
class HeldContact {
public:
  /// `system` must outlive it; `rows` of the system, each once.
  HeldContact(const ContactSystem& system, std::vector<std::size_t> rows);

  [[nodiscard]] const std::vector<std::size_t>& rows() const { return rows_; }
  [[nodiscard]] bool ok() const { return held_.ok(); } ///< false: the rows contradict each other

  struct Response {
    base::Matrix force;          ///< [held row, k]
    std::vector<base::Matrix> u; ///< [body][m, k] external displacements
    double left_over = 0.0;      ///< largest load on motions that no held row feels: they rest
  };
  /// To condensed loads [body][m, k] and gaps [held row, k] at zero displacement.
  [[nodiscard]] Response respond(const std::vector<base::Matrix>& load,
                                 const base::Matrix& gap) const;

private:
  const ContactSystem& system_;
  std::vector<std::size_t> rows_;
  solve::HeldRows held_;
};

} // namespace spricka::contact
