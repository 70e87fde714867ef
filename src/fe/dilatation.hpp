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
/// dilatation.cpp for each element, and for elements known when run.
template <shape::Element S> struct ProjectedDilatation {
  /// Number of functions phi of an element with so many corners: 1 + dim on quadratic
  /// quadrilaterals and hexahedra, else 1.
  static constexpr int mode_count_by_corners(int corners, bool quadratic) {
    return corners == 1 << S::dim && quadratic ? 1 + S::dim : 1;
  }
  /// Number of functions phi, or Eigen::Dynamic.
  static constexpr int modes = [] {
    if constexpr (shape::ElementShape<S>) {
      return mode_count_by_corners(base::element_info(S::type).corners,
                                   base::element_info(S::type).quadratic);
    } else {
      return Eigen::Dynamic;
    }
  }();
  static constexpr int most_modes = modes == Eigen::Dynamic ? 1 + S::dim : modes;
  static constexpr int most_freedoms = S::dim * shape::MatrixNodeCounts<S>::most_nodes;
  using Modes = Eigen::Matrix<double, modes, 1, 0, most_modes, 1>;
  using Volume =
      Eigen::Matrix<double, modes, modes == Eigen::Dynamic ? Eigen::Dynamic : most_freedoms,
                    modes == 1 ? Eigen::RowMajor : Eigen::ColMajor, most_modes, most_freedoms>;
  using Gram = Eigen::Matrix<double, modes, modes, 0, most_modes, most_modes>;

  Volume C; ///< integral of phi times the volume change of each freedom
  Gram G;   ///< integral of phi phi^T

  /// Number of functions phi of this element, also where it is known only when run.
  static int mode_count(const S& element) {
    if constexpr (shape::ElementShape<S>) {
      return modes;
    } else {
      return mode_count_by_corners(element.corners, element.quadratic);
    }
  }
  /// Values of the functions phi at a reference point: 1, then its coordinates where they belong to
  /// it.
  static Modes phi(const S& element, const shape::Point<S::dim>& r) {
    Modes p(mode_count(element));
    p[0] = 1.0;
    if constexpr (modes != 1) {
      if (p.size() > 1) {
        p.template tail<S::dim>() = r;
      }
    }
    return p;
  }

  ProjectedDilatation(const S& element, const NodeVectors<S>& X, const ConstitutiveLaw& law);

  /// Coefficients of the function whose integrals with phi these are.
  [[nodiscard]] Modes coefficients_from_integrals(const Modes& integrals) const;
  /// Of the volume change of displacements U [dim, nodes].
  [[nodiscard]] Modes project_displacement_dilatation(const NodeVectors<S>& U) const;
};

} // namespace spricka::fe
