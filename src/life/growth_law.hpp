// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "model/crack_growth.hpp"

#include <array>
#include <optional>
#include <vector>

namespace spricka::life {

/// The range of K that counts (ASTM E647): what lies below K = 0 closes the crack and does nothing,
/// delta K = K_max - max(K_min, 0) (life.1).
double tensile_K_range(double K_max, double K_min);

/// Newman's crack opening function K_op / K_max at the stress ratio R (Newman 1984; life.7).
class NewmanClosure {
public:
  NewmanClosure(double alpha, double stress_ratio);
  [[nodiscard]] double operator()(double R) const;

private:
  std::array<double, 4> A_;
};

/// da/dN of one cycle as a function of the K it begins, turns and ends with.
class GrowthRateLaw {
public:
  /// Forman and NASGRO need a toughness, a table its rows; increments go as Paris' law does.
  GrowthRateLaw(model::CrackGrowthLaw law, model::GrowthLawConstants constants);

  /// da/dN [length per cycle]. 0 if delta K is not above the threshold; infinite if Forman's or
  /// NASGRO's K_max reaches the toughness, where they have their pole. The other laws go on beyond
  /// it, a table straight on in its logarithms beyond its ends.
  [[nodiscard]] double growth_rate(double K_max, double K_min) const;

  /// The inverse: the delta K (life.1) of cycles with ratio R = K_min / K_max < 1 that grow by
  /// `rate` > 0. Not a number where no delta K above the threshold does so.
  [[nodiscard]] double K_range_for_rate(double rate, double R) const;

  [[nodiscard]] std::optional<double> toughness() const { return constants_.k_c; }
  [[nodiscard]] double threshold() const { return constants_.threshold; }
  /// Whether delta K lies within the rows of a table; the other laws have no such bounds.
  [[nodiscard]] bool is_within_table(double delta_K) const;
  /// Delta K of the first and the last row of a table [stress intensity]; empty for other laws.
  [[nodiscard]] std::optional<std::array<double, 2>> table_K_range() const;

private:
  [[nodiscard]] double formula(double range, double R) const;
  [[nodiscard]] double tabular(double range) const;
  [[nodiscard]] double tabular_range(double rate) const;
  [[nodiscard]] double by_root(double rate, double R) const;

  model::CrackGrowthLaw law_;
  model::GrowthLawConstants constants_;
  double scale_ = 0.0; ///< C in the units of the interface
  NewmanClosure closure_;
  std::vector<double> log_k_, log_rate_; ///< table, units of the interface
};

} // namespace spricka::life
