// SPDX-License-Identifier: GPL-3.0-or-later
#include "life/law_use_counter.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace spricka::life {

namespace {

constexpr double same = 1e-9; // a limit, through units and back, still belongs to the data

bool is_below(double value, const std::optional<double>& limit) {
  return limit && value < *limit * (1.0 - same);
}

bool is_above(double value, const std::optional<double>& limit) {
  return limit && value > *limit * (1.0 + same);
}

} // namespace

void LawUseCounter::add(double K_max, double K_min, double count, double rate) {
  if (!(rate > 0.0) || std::isinf(rate) || !(K_max > K_min)) {
    return; // a rate without bound ends the growth
  }
  const double R = law_.counted_ratio(K_min / K_max);
  const double range = tensile_K_range(K_max, K_min);
  const double delta_k = R < 0.0 ? K_max - K_min : range;
  cycles_ += count;
  growth_ += count * rate;
  sums_.lowest_delta_k = std::min(sums_.lowest_delta_k, delta_k);
  sums_.highest_delta_k = std::max(sums_.highest_delta_k, delta_k);
  sums_.lowest_ratio = std::min(sums_.lowest_ratio, R);
  sums_.highest_ratio = std::max(sums_.highest_ratio, R);
  const std::optional<std::array<double, 2>> rows = law_.table_K_range(R);
  const std::optional<std::array<double, 2>> columns = law_.table_ratios();
  const bool below_K =
      is_below(delta_k, data_.lowest_delta_k) || (rows && is_below(range, (*rows)[0]));
  const bool above_K =
      is_above(delta_k, data_.highest_delta_k) || (rows && is_above(range, (*rows)[1]));
  const bool below_R = (data_.lowest_ratio && R < *data_.lowest_ratio - same) ||
                       (columns && R < (*columns)[0] - same);
  const bool above_R = (data_.highest_ratio && R > *data_.highest_ratio + same) ||
                       (columns && R > (*columns)[1] + same);
  sums_.below_delta_k += below_K ? count : 0.0;
  sums_.above_delta_k += above_K ? count : 0.0;
  sums_.below_ratio += below_R ? count : 0.0;
  sums_.above_ratio += above_R ? count : 0.0;
  if (below_K || above_K || below_R || above_R) {
    sums_.outside += count;
    sums_.growth_outside += count * rate;
  }
}

model::LawUse LawUseCounter::use() const {
  model::LawUse parts = sums_;
  if (cycles_ > 0.0) {
    parts.outside /= cycles_;
    parts.growth_outside = growth_ > 0.0 ? parts.growth_outside / growth_ : 0.0;
    parts.below_delta_k /= cycles_;
    parts.above_delta_k /= cycles_;
    parts.below_ratio /= cycles_;
    parts.above_ratio /= cycles_;
  }
  return parts;
}

} // namespace spricka::life
