// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/vec.hpp"
#include "contact/condensed_body.hpp"
#include "contact/constraint.hpp"

#include <vector>

namespace spricka::contact {

/// The part of a body's compliance that belongs to rows which the next crack length has again.
struct PersistentRowCompliance {
  std::vector<std::vector<RowCoefficient>> rows; ///< [k] in a canonical order
  base::Matrix Y;                ///< [m, k] their half compliance; of early rows only
  base::Matrix W;                ///< [k, k] Y^T Y
  base::Matrix late_load;        ///< [late, k] FirstBlockFactor::second_block_load_reduction of Y
  solve::LastingColumns columns; ///< of an uncondensed body, in the place of all these
};

/// The rows that the next crack length has again, and what is kept of them for each body. The
/// compliances come out with the same bits whether anything was kept before or not.
struct PersistentRowSet {
  std::vector<bool> row;                      ///< [row] whether it is one of them; empty: none is
  std::vector<PersistentRowCompliance*> kept; ///< [body]; null where nothing may be kept
};

/// What a row weighs one freedom of a condensed body by.
struct BodyRowEntry {
  std::size_t body = 0;
  Eigen::Index at = 0;
  double weight = 0.0;
};

/// Constraint rows on all bodies, condensed to compliances.
struct ContactCompliances {
  base::Matrix W;             ///< [row, row]
  base::Matrix B;             ///< [row, mode]
  double flops = 0.0;         ///< of rows on whole bodies
  double opening_scale = 0.0; ///< what a unit of a mode opens where it moves along a row's forces
};

/// Compliances of rows on bodies; `entries` [row] of the same rows. Kept rows of `lasting` are read
/// where they serve, else made anew.
ContactCompliances assemble_compliances(const std::vector<const CondensedBody*>& bodies,
                                        const std::vector<std::vector<BodyRowEntry>>& entries,
                                        const std::vector<const ConstraintRow*>& rows,
                                        const PersistentRowSet& lasting);

} // namespace spricka::contact
