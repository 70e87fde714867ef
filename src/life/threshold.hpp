// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "life/newman_closure.hpp"
#include "model/crack_growth.hpp"

#include <optional>

namespace spricka::life {

/// The delta K below which a crack does not grow: one constant, or NASGRO's function of R and of
/// the length of the crack (Forman and Mettu 1992; NASGRO reference manual 4; life.25, life.26).
class FatigueThreshold {
public:
  explicit FatigueThreshold(const model::GrowthLawConstants& constants);

  /// Delta K = K_max - K_min, for R < 0 too, of cycles with R < 1 on a crack of length `a` > 0
  /// (infinite: a long one) [stress intensity]. A constant is one of the part of delta K above
  /// K = 0, and returned as it is.
  [[nodiscard]] double operator()(double R, double a) const;
  /// Whether it is a function of R.
  [[nodiscard]] bool varies() const { return over_ratio_.has_value(); }

private:
  double constant_;
  std::optional<model::ThresholdOverRatio> over_ratio_;
  NewmanClosure closure_;
  double at_full_ratio_ = 0.0; ///< of long cracks for R to 1 [stress intensity]
};

} // namespace spricka::life
