// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "solve/condense.hpp"

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace spricka::solve {

/// A part of a body that has a factor of its own: its externals are unknowns of the region, into
/// whose matrix its Schur complement went.
struct FactorisedPart {
  std::shared_ptr<const Condensation> factor;
  std::int64_t locals = 0;
  std::vector<std::int64_t> rows; ///< [externals of the part] unknown of the region
};

/// Columns that a part will meet again whatever the region becomes, and what was found of them.
struct LastingColumns {
  SparseRightHandSides F; ///< [locals of the part, k]
  RowCompliance own;      ///< by the part alone, its externals held
};

/// The stiffness matrix of a body by the factors of its parts and of the region that they stand in
/// (substructuring; Przemieniecki, J. S., Matrix structural analysis of substructures, AIAA J. 1,
/// 1963, eqs. 7 to 15): the same solutions as by one factor of the whole, while a part is
/// factorised once for all regions. Unknowns: locals of the parts, one part after the other, then
/// those of the region, of which the last are external.
class SubstructuredFactor {
public:
  SubstructuredFactor() = default;
  SubstructuredFactor(std::vector<FactorisedPart> parts, std::shared_ptr<Condensation> region,
                      std::int64_t region_unknowns);

  [[nodiscard]] bool empty() const { return region_ == nullptr; }
  [[nodiscard]] std::int64_t size() const { return region_begin() + region_unknowns_; }
  /// The Schur complement on the externals; once.
  [[nodiscard]] base::Matrix take_schur() { return region_->take_schur(); }
  /// All unknowns [n, k] of loads f [n, k]; `displacement` gives those of the externals from the
  /// loads condensed to them.
  [[nodiscard]] base::Matrix solve(const base::Matrix& f,
                                   const ExternalDisplacementSolver& displacement) const;
  /// F^T K^-1 F [k, k] of columns F [n, k] with the externals held, and F condensed to these. The
  /// first `lasting` columns act on lasting_unknowns() alone; what `kept` has of them is taken from
  /// there, or left there. It makes no difference in the bits.
  [[nodiscard]] RowCompliance compliance_with_externals_held(const SparseRightHandSides& F,
                                                             std::int64_t lasting = 0,
                                                             LastingColumns* kept = nullptr) const;
  /// Columns may be kept that act on this many first unknowns alone.
  [[nodiscard]] std::int64_t lasting_unknowns() const {
    return parts_.empty() ? size() : parts_.size() == 1 ? region_begin() : 0;
  }
  /// What kept columns belong to: another factor makes them worthless.
  [[nodiscard]] std::shared_ptr<const void> lasting_factor() const {
    return parts_.empty() ? std::shared_ptr<const void>(region_) : parts_.front().factor;
  }

private:
  [[nodiscard]] std::int64_t region_begin() const { return first_.back(); }
  /// Those of the columns F that have entries in some range of unknowns, and these entries.
  struct ColumnsOfRange {
    std::vector<std::int64_t> column; ///< of F
    SparseRightHandSides F;           ///< rows counted from the beginning of the range
  };
  static ColumnsOfRange columns_of_range(const SparseRightHandSides& F, std::int64_t begin,
                                         std::int64_t end);
  /// F as it acts on the region, with what the parts' `own` solutions hand on.
  [[nodiscard]] SparseRightHandSides on_region(const SparseRightHandSides& F,
                                               const std::vector<ColumnsOfRange>& columns,
                                               const std::vector<RowCompliance>& own) const;
  /// Solves the parts from `part` on and the region, whose loads f are added to; u is written.
  void solve_from(std::size_t part, const base::Matrix& f, base::Matrix& region_load,
                  const ExternalDisplacementSolver& displacement, base::Matrix& u) const;

  std::vector<FactorisedPart> parts_;
  std::vector<std::int64_t> first_{0}; ///< [part + 1] first unknown of each; then of the region
  std::shared_ptr<Condensation> region_;
  std::int64_t region_unknowns_ = 0;
};

} // namespace spricka::solve
