// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "fe/stress.hpp"

#include <array>
#include <span>

namespace spricka::fe {

/// The stress of an element at one of its superconvergent points.
struct StressSample {
  base::Vec3 x = base::Vec3::Zero();
  Stress stress = Stress::Zero();
  /// The element's extent: the ways through it along its reference coordinates, columns.
  Eigen::Matrix3d extent = Eigen::Matrix3d::Zero();
  double longest = 0.0; ///< the lengths of these ways together: no width of the element is larger
};

/// Polynomials of degree 1 or 2 in x for the six stresses, fitted to samples by least squares along
/// their principal axes. Terms that the samples do not determine are left out: those across a
/// single layer of elements.
class FittedStressPolynomial {
public:
  /// One sample or more; `dim` 2 or 3.
  FittedStressPolynomial(std::span<const StressSample* const> samples, int dim, int degree);

  /// Whether no term of the degree asked for is left out.
  [[nodiscard]] bool has_all_terms() const { return complete_; }
  /// The fitted stress [stress] at a place, which may lie beyond the samples.
  [[nodiscard]] Stress at(const base::Vec3& x) const;

private:
  static constexpr int most = 10; ///< terms of degree 2 in space
  using Terms = Eigen::Matrix<double, most, 1>;

  void choose_axes(std::span<const StressSample* const> samples);
  template <int dim> [[nodiscard]] Terms terms(const base::Vec3& x) const;
  template <int dim> void fit(std::span<const StressSample* const> samples);

  base::Vec3 centre_ = base::Vec3::Zero();
  Eigen::Matrix3d axes_ = Eigen::Matrix3d::Zero(); ///< rows: axes over the spread along them, or 0
  int dim_;
  int count_; ///< terms of the degree asked for
  bool complete_ = true;
  Eigen::Matrix<double, 6, most> coefficient_ = Eigen::Matrix<double, 6, most>::Zero();
};

} // namespace spricka::fe
