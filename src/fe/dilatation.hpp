// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "fe/jacobian.hpp"
#include "fe/law.hpp"

namespace spricka::fe {

/// Projected dilatation (mixed elements with a discontinuous pressure, condensed; Hughes 1980,
/// B-bar; stability of the pairs: Boffi, Brezzi, Fortin 2013). The volume change theta = div u is
/// replaced by its projection onto phi: 1 on triangles, tetrahedra, wedges and linear elements,
/// 1 and the reference coordinates on quadratic quadrilaterals and hexahedra. The energy of the
/// volume change is lambda/2 times the integral of the projected theta squared. Compiled in
/// dilatation.cpp for each element.
template <shape::ElementShape S> struct Dilatation {
  static constexpr bool full = base::info(S::type).corners == 1 << S::dim;
  static constexpr int modes = full && base::info(S::type).quadratic ? 1 + S::dim : 1;
  using Modes = Eigen::Matrix<double, modes, 1>;
  using Volume = Eigen::Matrix<double, modes, S::dim * S::nodes>;

  Volume C = Volume::Zero(); ///< integral of phi times the volume change of each freedom
  Eigen::Matrix<double, modes, modes> G = Eigen::Matrix<double, modes, modes>::Zero();

  static Modes phi(const shape::Point<S::dim>& r) {
    Modes p;
    p[0] = 1.0;
    if constexpr (modes > 1) {
      p.template tail<S::dim>() = r;
    }
    return p;
  }

  Dilatation(const NodeVectors<S>& X, const Law& law);

  /// Coefficients of the projected volume change of displacements u [dim * nodes].
  [[nodiscard]] Modes of(const Eigen::Matrix<double, S::dim * S::nodes, 1>& u) const;
};

} // namespace spricka::fe
