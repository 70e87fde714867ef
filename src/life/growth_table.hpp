// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "model/crack_growth.hpp"

#include <array>
#include <cstddef>
#include <vector>

namespace spricka::life {

/// da/dN by rows of delta K and rate, of one R or of columns of several: straight in the logarithms
/// between the rows and on beyond them (life.9); between columns at equal rate by Walker's exponent
/// of the two around R, beyond them by that of the nearest two (life.30).
class GrowthRateTable {
public:
  /// The rows of a law, in the units of the interface; none of other laws.
  explicit GrowthRateTable(const model::GrowthLawConstants& constants);

  /// da/dN [length per cycle] at the part of delta K above K = 0 (life.1) and at R < 1.
  [[nodiscard]] double rate(double range, double R) const;
  /// The inverse of rate(). Not a number where rates do not rise all the way.
  [[nodiscard]] double K_range(double rate, double R) const;
  /// The part of delta K above K = 0 in the first and the last row at R.
  [[nodiscard]] std::array<double, 2> K_ends(double R) const;
  /// Whether some column has R < 0, so that delta K is K_max - K_min there; else R < 0 counts as 0.
  [[nodiscard]] bool has_negative_ratio() const { return !ratios_.empty() && ratios_[0] < 0.0; }
  /// R of the columns, ascending; empty: one column for all R.
  [[nodiscard]] const std::vector<double>& ratios() const { return ratios_; }

private:
  /// Where R lies: log delta K of a row is that of column `left` and `right` by parts.
  struct BetweenColumns {
    std::size_t left = 0, right = 0;
    double part = 0.0;  ///< of the right one
    double shift = 0.0; ///< log of delta K over its part above K = 0
  };
  [[nodiscard]] BetweenColumns between_columns(double R) const;
  [[nodiscard]] double log_range(const BetweenColumns& at, std::size_t row) const;

  std::vector<double> ratios_;              ///< [column], ascending; empty: one column for all R
  std::vector<std::vector<double>> log_k_;  ///< [column][row], ascending with the row
  std::vector<double> log_rate_;            ///< [row]
  std::vector<std::array<double, 2>> ends_; ///< [column pair] of `part`, where rows still ascend
  bool rises_ = false;                      ///< rates with the rows
};

} // namespace spricka::life
