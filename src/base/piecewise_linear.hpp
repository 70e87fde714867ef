// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <cstddef>
#include <cstdint>
#include <vector>

namespace spricka::base {

/// A continuous function that is linear between ascending knots. A value costs some nanoseconds: a
/// uniform index over the range leads to the segment, or to a short list of them that is bisected.
class PiecewiseLinear {
public:
  PiecewiseLinear() = default;
  /// knot [n + 1] ascending, n >= 1; value [n] at the segments' beginnings and slope [n].
  PiecewiseLinear(std::vector<double> knot, std::vector<double> value, std::vector<double> slope);

  /// knot [n + 1] ascending and the value at each of them, n >= 1.
  static PiecewiseLinear through(std::vector<double> knot, std::vector<double> value);

  [[nodiscard]] bool empty() const { return value_.empty(); }
  [[nodiscard]] std::size_t segment_count() const { return value_.size(); }
  [[nodiscard]] const std::vector<double>& knots() const { return knot_; }
  [[nodiscard]] const std::vector<double>& segment_start_values() const {
    return value_;
  }                                                                                  ///< [segment]
  [[nodiscard]] const std::vector<double>& segment_slopes() const { return slope_; } ///< [segment]
  /// Derivative within a segment, from its knot to the next.
  [[nodiscard]] double slope(std::size_t segment) const { return slope_[segment]; }

  /// Not a number outside the knots: nothing is extrapolated.
  [[nodiscard]] double operator()(double t) const;
  /// Value at knot k, the last one among them.
  [[nodiscard]] double value_at_knot(std::size_t k) const;
  /// Slope left of knot k; at the first knot that of the first segment.
  [[nodiscard]] double slope_before(std::size_t k) const { return slope_[k > 0 ? k - 1 : 0]; }
  /// Slope right of knot k; at the last knot that of the last segment.
  [[nodiscard]] double slope_after(std::size_t k) const {
    return slope_[k < slope_.size() ? k : slope_.size() - 1];
  }
  /// The segment with t; of two that meet there the first. t must lie within the knots.
  [[nodiscard]] std::size_t find_segment(double t) const;
  /// Smallest and largest value: they are at knots.
  [[nodiscard]] double smallest_value() const;
  [[nodiscard]] double largest_value() const;

private:
  std::vector<double> knot_, value_, slope_;
  std::vector<std::uint32_t> index_; ///< first segment of each of the equal bins, and one behind
  double bins_per_t_ = 0.0;
};

} // namespace spricka::base
