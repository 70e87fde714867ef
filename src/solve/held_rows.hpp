// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "solve/contact_qp.hpp"

namespace spricka::solve {

/// Forces on rows that are held whatever their sign, and the modes.
struct HeldRows {
  bool ok = false;
  base::Matrix lambda;    ///< [n, k] zero on redundant rows
  base::Matrix alpha;     ///< [m, k] modes that no row feels rest
  double left_over = 0.0; ///< largest load on those modes
};

/// Solves W lambda + B alpha = -b, B^T lambda = -h for several b [n, k] and h [m, k]: the contact
/// problem of `rows` with all its rows closed and its own b and h left aside (manual,
/// sensitivity.3). Not ok: W is singular beyond redundant rows.
HeldRows hold_rows(const ContactProblem& rows, const base::Matrix& b, const base::Matrix& h);

} // namespace spricka::solve
