// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/vec.hpp"
#include "crack/k_layout.hpp"
#include "crack/supplementary_functions.hpp"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace spricka::crack {

/// Rows of K as they are added up: of each function its coefficients in K of those points of the
/// front that have some, which are few.
class IntensityFunctionalSums {
public:
  /// Of so many functions with `dim` directions each; K are those of `layout`.
  IntensityFunctionalSums(Eigen::Index functions, int dim, const KLayout& layout)
      : dim_(dim), layout_(layout), newest_(static_cast<std::size_t>(functions), none) {}

  /// Adds the coefficients of a function in K of a mode, 1 and on, at a point. [dim]
  template <class Coefficients>
  void add(Eigen::Index function, std::size_t point, int mode, const Coefficients& value) {
    double* const at = of_point(static_cast<std::size_t>(function), point) +
                       static_cast<std::ptrdiff_t>(dim_) * (mode - 1);
    for (Eigen::Index c = 0; c < value.size(); ++c) {
      at[c] += value[c];
    }
  }

  /// What has been added up, without zeros. [dim * functions, K]
  [[nodiscard]] SparseLinearFunctionals assemble() const;

private:
  static constexpr std::int32_t none = -1;
  /// Coefficients of a function in K of a point stand in values_, by mode.
  struct Block {
    std::size_t point;
    std::int32_t before; ///< the function's block before this one, or none
  };
  [[nodiscard]] std::size_t block_size() const {
    return static_cast<std::size_t>(dim_ * layout_.mode_count());
  }
  /// The first of the coefficients of a function in K of a point.
  double* of_point(std::size_t function, std::size_t point);

  int dim_;
  KLayout layout_;
  std::vector<std::int32_t> newest_; ///< [function] its last block, or none
  std::vector<Block> blocks_;
  std::vector<double> values_; ///< [block][mode][dim]
};

} // namespace spricka::crack
