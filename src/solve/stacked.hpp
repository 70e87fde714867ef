// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "solve/condense.hpp"

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace spricka::solve {

/// Condensation in two floors. Below, the sparse matrix of the elements, condensed to the rows that
/// dense blocks have too and to the externals it touches; on top, these rows and the blocks in one
/// full matrix, of which those that are not external are eliminated. What a crack leaves alone, one
/// large block, passes through no sparse matrix.
class Stacked {
public:
  /// The symbolic phase alone, as Condensation::forecast.
  static FactorReport forecast(const base::SymmetricCsc& K, std::int64_t externals,
                               std::span<const DenseBlock> blocks);
  /// K as Condensation takes it, without the blocks; S [externals, externals] and the report are
  /// written.
  Stacked(const base::SymmetricCsc& K, std::int64_t externals, std::span<const DenseBlock> blocks,
          base::Matrix& S, FactorReport& report);

  /// As those of Condensation.
  [[nodiscard]] base::Matrix condense_load(const base::Matrix& f) const;
  [[nodiscard]] base::Matrix recover(const base::Matrix& u_external, const base::Matrix& f) const;

private:
  struct Rows {
    std::vector<std::int64_t> below;   ///< rows of K that are eliminated below
    std::vector<std::int64_t> top;     ///< rows of K on top, externals last
    std::vector<Eigen::Index> touched; ///< places in `top` that the sparse matrix touches
    [[nodiscard]] Eigen::Index inner() const {
      return static_cast<Eigen::Index>(top.size()) - external;
    }
    Eigen::Index external = 0;
  };
  static Rows divide(const base::SymmetricCsc& K, std::int64_t externals,
                     std::span<const DenseBlock> blocks);
  static base::SymmetricCsc sparse_part(const base::SymmetricCsc& K, const Rows& rows);
  static void add_top(const Rows& rows, FactorReport& report);
  bool eliminate(const base::Matrix& D, base::Matrix& S, FactorReport& report);
  [[nodiscard]] base::Matrix below(const base::Matrix& f) const;
  [[nodiscard]] base::Matrix on_top(const base::Matrix& f, const base::Matrix& f_below) const;

  Rows rows_;
  std::optional<Condensation> below_;
  base::Matrix L_; ///< [inner, inner] Cholesky factor of the rows eliminated on top
  base::Matrix X_; ///< [inner, externals] L^-1 times their coupling with the externals
};

} // namespace spricka::solve
