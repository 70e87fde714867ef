// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/element_type.hpp"
#include "base/id.hpp"
#include "base/vec.hpp"

#include <Eigen/SparseCore>

#include <cstdint>
#include <functional>
#include <span>

/// What K along a front is a linear function of.
namespace spricka::crack {

/// Coefficients of linear functions, one in each column.
using SparseLinearFunctionals = Eigen::SparseMatrix<double>;

/// Functions beside those of the nodes, three directions each.
struct SupplementaryFunctions {
  Eigen::Index count = 0;
  /// Of an element: their numbers and signs.
  std::function<std::span<const std::int32_t>(base::ElementId)> of_element;
  std::function<std::span<const double>(base::ElementId)> signs;
  /// Of a type: their slopes by its reference coordinates [function, 3].
  std::function<Eigen::MatrixX3d(base::ElementType, const base::Vec3&)> slopes;
};

/// K as functions of nodal displacements and of what multiplies other functions.
struct IntensityFunctionals {
  SparseLinearFunctionals of_nodes;  ///< [dim * node, K]
  SparseLinearFunctionals of_others; ///< [dim * count, K]
};

} // namespace spricka::crack
