// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "life/growth_law.hpp"
#include "model/law_use.hpp"

namespace spricka::life {

/// Counts the cycles that a law is asked for, within and outside the data behind it: the range that
/// its card states, and the rows and columns of a table. Law and data must outlive it.
class LawUseCounter {
public:
  LawUseCounter(const GrowthRateLaw& law, const model::GrowthLawData& data)
      : law_(law), data_(data) {}

  /// `count` cycles that grow by `rate` each; those with none are left out.
  void add(double K_max, double K_min, double count, double rate);
  /// Of all so far, as parts of them.
  [[nodiscard]] model::LawUse use() const;

private:
  const GrowthRateLaw& law_;
  const model::GrowthLawData& data_;
  model::LawUse sums_; ///< its parts are numbers of cycles, and growth
  double cycles_ = 0.0;
  double growth_ = 0.0;
};

} // namespace spricka::life
