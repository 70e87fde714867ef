// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/sparse.hpp"
#include "base/vec.hpp"
#include "solve/factor_panels.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace spricka::solve {

/// What a thread needs for itself while it works on panels.
struct PanelWorkspace {
  std::vector<std::int32_t> place; ///< [n] of the rows of the panel in hand
  base::Matrix product;
};

/// The arithmetic of a sparse Cholesky factorisation on panels and their tiles, each for itself:
/// the entries of A, what earlier panels take off them, the block on the diagonal and the rows
/// below.
class PanelElimination {
public:
  /// `values` of the factor that was cut up are written. A [n, n]: in the order of elimination,
  /// each entry once, in the column that is eliminated first (rows in any order). All must outlive
  /// this.
  PanelElimination(const FactorPanels& cut, double* values, const base::SymmetricCsc& A)
      : values_(values), A_(A), cut_(cut) {}

  /// The entries of A in the rows of a tile, the others zero.
  void begin_tile(const PanelTile& tile) const;
  /// Takes off a tile what these panels do to it, in their order.
  void take_off(const PanelTile& tile, std::span<const PanelUpdate> updates,
                PanelWorkspace& work) const;
  /// Factorises the block on the diagonal: the first column with a pivot that is not positive, the
  /// one behind the panel where there is none.
  [[nodiscard]] std::int64_t factorise_diagonal(const FactorPanel& p) const;
  /// Rows [begin, end) of a panel whose block on the diagonal is factorised.
  void eliminate_below(const FactorPanel& p, int begin, int end) const;

private:
  void set_places(const PanelTile& tile, PanelWorkspace& work) const;
  void subtract_product(const FactorPanel& p, const FactorPanel& from, const PanelUpdate& u, int lo,
                        int hi, PanelWorkspace& work) const;

  double* values_;
  const base::SymmetricCsc& A_;
  const FactorPanels& cut_;
};

} // namespace spricka::solve
