// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "life/growth_table.hpp"
#include "life/newman_closure.hpp"
#include "life/threshold.hpp"
#include "model/crack_growth.hpp"

#include <array>
#include <optional>

namespace spricka::life {

/// The range of K that counts (ASTM E647): what lies below K = 0 closes the crack and does nothing,
/// delta K = K_max - max(K_min, 0) (life.1).
double tensile_K_range(double K_max, double K_min);

/// da/dN of one cycle as a function of the K it begins, turns and ends with.
class GrowthRateLaw {
public:
  /// Forman, NASGRO, Hartman and Schijve need a toughness, a table its rows; increments go as
  /// Paris' law does.
  GrowthRateLaw(model::CrackGrowthLaw law, model::GrowthLawConstants constants);

  /// da/dN [length per cycle]. 0 if delta K is not above the threshold; infinite if K_max of
  /// a law that needs a toughness reaches it, where the law has its pole. The others go on beyond
  /// it, a table straight on in its logarithms beyond its ends.
  [[nodiscard]] double growth_rate(double K_max, double K_min,
                                   const model::PlaceOnCrack& place = {}) const;

  /// The inverse: the delta K (life.1) of cycles with ratio R = K_min / K_max < 1 that grow by
  /// `rate` > 0. Not a number where no delta K above the threshold does so.
  [[nodiscard]] double K_range_for_rate(double rate, double R,
                                        const model::PlaceOnCrack& place = {}) const;

  /// The delta K (life.1) of cycles with ratio R < 1 that is not enough to grow.
  [[nodiscard]] double threshold(double R, const model::PlaceOnCrack& place = {}) const;
  /// The R that the rate is made with: laws that do not know R < 0 count it as 0.
  [[nodiscard]] double counted_ratio(double R) const;
  /// Whether the threshold is one constant above 0 for all R.
  [[nodiscard]] bool has_constant_threshold() const {
    return !threshold_.varies() && constants_.threshold > 0.0;
  }
  /// Whether a threshold that is one constant for all R holds a cycle back, or slows it down to
  /// much less, that has another R than 0.
  [[nodiscard]] bool is_held_by_constant_threshold(double K_max, double K_min) const;
  /// Whether delta K (life.1) lies within the rows that a table has at R; the other laws have no
  /// such bounds.
  [[nodiscard]] bool is_within_table(double delta_K, double R) const;
  /// Delta K (life.1) of the first and the last row of a table at R [stress intensity]; empty for
  /// other laws.
  [[nodiscard]] std::optional<std::array<double, 2>> table_K_range(double R) const;

  /// R of the first and the last column of a table over several R; empty for other laws.
  [[nodiscard]] std::optional<std::array<double, 2>> table_ratios() const;

private:
  [[nodiscard]] double formula(double range, double R, double threshold,
                               const model::PlaceOnCrack& place) const;
  [[nodiscard]] double walker_exponent(double R) const;
  [[nodiscard]] double toughness_at(const model::PlaceOnCrack& place) const {
    return place.toughness ? *place.toughness : *constants_.k_c;
  }
  [[nodiscard]] double by_root(double rate, double R, double threshold,
                               const model::PlaceOnCrack& place) const;

  model::CrackGrowthLaw law_;
  model::GrowthLawConstants constants_;
  double scale_ = 0.0; ///< C in the units of the interface
  NewmanClosure closure_;
  FatigueThreshold threshold_;
  GrowthRateTable table_;
};

} // namespace spricka::life
