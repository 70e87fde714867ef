// SPDX-License-Identifier: GPL-3.0-or-later
#include "life/growth_table.hpp"

#include "life/no_value.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <functional>
#include <limits>

namespace spricka::life {

namespace {

// y at x on the polyline through `rows` points (knot, value), straight on beyond its ends.
template <class Knot, class Value>
double on_polyline(std::size_t rows, const Knot& knot, const Value& value, double x) {
  std::size_t i = 1;
  for (std::size_t count = rows - 2; count > 0;) { // the first knot above x
    const std::size_t half = count / 2;
    if (x < knot(i + half)) {
      count = half;
    } else {
      i += half + 1;
      count -= half + 1;
    }
  }
  const double t = (x - knot(i - 1)) / (knot(i) - knot(i - 1));
  return value(i - 1) + t * (value(i) - value(i - 1));
}

// How far the exponent of two columns may lead, as a part of the way from the first to the second:
// not so far that rows would cross.
std::array<double, 2> limits_of_part(const std::vector<double>& left,
                                     const std::vector<double>& right) {
  constexpr double most = 0.9; // of the way from a column to where two rows meet
  double low = -std::numeric_limits<double>::infinity();
  double high = std::numeric_limits<double>::infinity();
  for (std::size_t i = 1; i < left.size(); ++i) {
    const double at_left = left[i] - left[i - 1];
    const double at_right = right[i] - right[i - 1];
    if (at_right < at_left) {
      high = std::min(high, 1.0 + most * at_right / (at_left - at_right));
    } else if (at_right > at_left) {
      low = std::max(low, -most * at_left / (at_right - at_left));
    }
  }
  return {low, high};
}

} // namespace

GrowthRateTable::GrowthRateTable(const model::GrowthLawConstants& constants)
    : ratios_(constants.table_ratios) {
  const std::size_t rows = constants.growth.size();
  for (std::size_t column = 0; rows > 0 && column * rows < constants.delta_k.size(); ++column) {
    std::vector<double>& logs = log_k_.emplace_back();
    for (std::size_t i = 0; i < rows; ++i) {
      logs.push_back(std::log(constants.delta_k[column * rows + i] * constants.k_unit));
    }
  }
  for (const double rate : constants.growth) {
    log_rate_.push_back(std::log(rate * constants.a_unit));
  }
  for (std::size_t column = 1; column < log_k_.size(); ++column) {
    ends_.push_back(limits_of_part(log_k_[column - 1], log_k_[column]));
  }
  rises_ = std::ranges::is_sorted(log_rate_, std::less_equal<>());
}

// (life.30): log delta K at equal rate is straight over log (1 - R).
GrowthRateTable::BetweenColumns GrowthRateTable::between_columns(double R) const {
  if (ratios_.size() < 2) {
    return {};
  }
  const double counted = has_negative_ratio() ? R : std::max(R, 0.0);
  const auto above = std::upper_bound(ratios_.begin() + 1, ratios_.end() - 1, counted);
  const auto right = static_cast<std::size_t>(above - ratios_.begin());
  const double open = 1.0 - ratios_[right - 1];
  const double part = std::log((1.0 - counted) / open) / std::log((1.0 - ratios_[right]) / open);
  return {.left = right - 1,
          .right = right,
          .part = std::clamp(part, ends_[right - 1][0], ends_[right - 1][1]),
          .shift = counted < 0.0 ? std::log(1.0 - counted) : 0.0};
}

double GrowthRateTable::log_range(const BetweenColumns& at, std::size_t row) const {
  const double left = log_k_[at.left][row];
  return at.left == at.right ? left : left + at.part * (log_k_[at.right][row] - left) - at.shift;
}

double GrowthRateTable::rate(double range, double R) const {
  const BetweenColumns at = between_columns(R);
  return std::exp(on_polyline(
      log_rate_.size(), [&](std::size_t i) { return log_range(at, i); },
      [&](std::size_t i) { return log_rate_[i]; }, std::log(range)));
}

double GrowthRateTable::K_range(double rate, double R) const {
  if (!rises_) {
    return no_value;
  }
  const BetweenColumns at = between_columns(R);
  return std::exp(on_polyline(
      log_rate_.size(), [&](std::size_t i) { return log_rate_[i]; },
      [&](std::size_t i) { return log_range(at, i); }, std::log(rate)));
}

std::array<double, 2> GrowthRateTable::K_ends(double R) const {
  assert(!log_rate_.empty());
  const BetweenColumns at = between_columns(R);
  return {std::exp(log_range(at, 0)), std::exp(log_range(at, log_rate_.size() - 1))};
}

} // namespace spricka::life
