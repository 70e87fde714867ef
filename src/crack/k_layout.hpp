// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <cstddef>

#include <Eigen/Core>

namespace spricka::crack {

/// Which column (or row) of a block of functionals is which K, and the only place that knows: the
/// points of the fronts one after another, the modes of each side by side, two in the plane and
/// three in space.
class KLayout {
public:
  KLayout(std::size_t points, int dim) : points_(points), modes_(dim) {}

  [[nodiscard]] std::size_t points() const { return points_; }
  [[nodiscard]] Eigen::Index mode_count() const { return modes_; }
  /// All K together.
  [[nodiscard]] Eigen::Index count() const { return static_cast<Eigen::Index>(points_) * modes_; }
  /// The first mode of a point; its others follow.
  [[nodiscard]] Eigen::Index first_mode_index(std::size_t point) const {
    return static_cast<Eigen::Index>(point) * modes_;
  }
  /// Index of the K of a mode, 1, 2 or 3, at a point of the fronts.
  [[nodiscard]] Eigen::Index at(std::size_t point, int mode) const {
    return first_mode_index(point) + mode - 1;
  }
  /// The columns of a block [.., count()] that are K of a point.
  template <class Block> [[nodiscard]] auto point_columns(Block&& block, std::size_t point) const {
    return block.middleCols(first_mode_index(point), modes_);
  }
  /// The entries of a vector [count() ..] that are K of a point.
  template <class Vector>
  [[nodiscard]] auto segment_of_point(Vector&& vector, std::size_t point) const {
    return vector.segment(first_mode_index(point), modes_);
  }

private:
  std::size_t points_;
  Eigen::Index modes_;
};

} // namespace spricka::crack
