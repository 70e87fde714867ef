// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/piecewise_linear.hpp"

#include <algorithm>
#include <cassert>
#include <limits>
#include <utility>

namespace spricka::base {

namespace {

constexpr std::size_t bins_per_segment = 2;

} // namespace

PiecewiseLinear::PiecewiseLinear(std::vector<double> knot, std::vector<double> value,
                                 std::vector<double> slope)
    : knot_(std::move(knot)), value_(std::move(value)), slope_(std::move(slope)) {
  assert(!value_.empty() && knot_.size() == value_.size() + 1 && slope_.size() == value_.size());
  const std::size_t bins = bins_per_segment * segment_count();
  const double length = knot_.back() - knot_.front();
  bins_per_t_ = length > 0.0 ? static_cast<double>(bins) / length : 0.0;
  std::size_t s = 0;
  for (std::size_t k = 0; k <= bins; ++k) {
    const double t = knot_.front() + length * static_cast<double>(k) / static_cast<double>(bins);
    while (s + 1 < segment_count() && knot_[s + 1] < t) {
      ++s;
    }
    index_.push_back(static_cast<std::uint32_t>(s));
  }
}

std::size_t PiecewiseLinear::find_segment(double t) const {
  const auto bin =
      std::min(static_cast<std::size_t>((t - knot_.front()) * bins_per_t_), index_.size() - 2);
  // the bin's bounds are rounded: one segment more on either side
  std::size_t first = index_[bin] > 0 ? index_[bin] - 1 : 0;
  std::size_t last = std::min<std::size_t>(index_[bin + 1] + 1, segment_count() - 1);
  while (last - first > 4) {
    const std::size_t middle = (first + last) / 2;
    if (knot_[middle + 1] < t) {
      first = middle + 1;
    } else {
      last = middle;
    }
  }
  while (first < last && knot_[first + 1] < t) {
    ++first;
  }
  return first;
}

PiecewiseLinear PiecewiseLinear::through(std::vector<double> knot, std::vector<double> value) {
  assert(knot.size() >= 2 && value.size() == knot.size());
  std::vector<double> slope;
  for (std::size_t k = 0; k + 1 < knot.size(); ++k) {
    slope.push_back((value[k + 1] - value[k]) / (knot[k + 1] - knot[k]));
  }
  value.pop_back();
  return {std::move(knot), std::move(value), std::move(slope)};
}

double PiecewiseLinear::operator()(double t) const {
  if (value_.empty() || !(t >= knot_.front() && t <= knot_.back())) {
    return std::numeric_limits<double>::quiet_NaN();
  }
  const std::size_t s = find_segment(t);
  return value_[s] + (t - knot_[s]) * slope_[s];
}

double PiecewiseLinear::value_at_knot(std::size_t k) const {
  return k < segment_count() ? value_[k]
                             : value_[k - 1] + (knot_[k] - knot_[k - 1]) * slope_[k - 1];
}

double PiecewiseLinear::smallest_value() const {
  return std::min(*std::min_element(value_.begin(), value_.end()), value_at_knot(segment_count()));
}

double PiecewiseLinear::largest_value() const {
  return std::max(*std::max_element(value_.begin(), value_.end()), value_at_knot(segment_count()));
}

} // namespace spricka::base
