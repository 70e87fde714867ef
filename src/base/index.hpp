// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <Eigen/Core>
#include <concepts>
#include <cstddef>

/// Places in containers: the standard library counts unsigned, Eigen and BLAS signed.
namespace spricka::base {

/// Place i >= 0 as a subscript of a standard container.
template <std::integral I> [[nodiscard]] constexpr std::size_t at(I i) {
  return static_cast<std::size_t>(i);
}

/// Place or size i as one of an Eigen matrix.
template <std::integral I> [[nodiscard]] constexpr Eigen::Index index(I i) {
  return static_cast<Eigen::Index>(i);
}

} // namespace spricka::base
