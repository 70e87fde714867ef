// SPDX-License-Identifier: GPL-3.0-or-later
#include "fe/dilatation.hpp"

#include "shape/solid.hpp"

#include <Eigen/LU>

namespace spricka::fe {

// Written out by components: products of so many sizes take the compiler long.
template <shape::Element S>
ProjectedDilatation<S>::ProjectedDilatation(const S& element, const NodeVectors<S>& X,
                                            const ConstitutiveLaw& law)
    : C(Volume::Zero(mode_count(element), S::dim * element.nodes)),
      G(Gram::Zero(mode_count(element), mode_count(element))) {
  // (fe.14), by the rule of the stiffness, which the projection is a part of.
  for (const auto& point : stiffness_rule(element, law)) {
    const Jacobian<S> at = jacobian(element, X, point.r);
    const HoopStrain<S> hoop(element, X, law, point.r);
    const double w = point.weight * at.det * law.depth(hoop.x);
    const Modes p = phi(element, point.r);
    for (Eigen::Index m = 0; m < p.size(); ++m) {
      for (int i = 0; i < element.nodes; ++i) {
        for (int c = 0; c < S::dim; ++c) {
          const double theta = at.dNdx(i, c) + (c == 0 ? hoop.h[i] : 0.0);
          C(m, S::dim * i + c) += w * p[m] * theta;
        }
      }
      for (Eigen::Index n = 0; n < p.size(); ++n) {
        G(m, n) += w * p[m] * p[n];
      }
    }
  }
}

template <shape::Element S>
auto ProjectedDilatation<S>::project_displacement_dilatation(const NodeVectors<S>& U) const
    -> Modes {
  Modes integrals = Modes::Zero(C.rows());
  for (Eigen::Index m = 0; m < C.rows(); ++m) {
    for (Eigen::Index i = 0; i < U.cols(); ++i) {
      for (int c = 0; c < S::dim; ++c) {
        integrals[m] += C(m, S::dim * i + c) * U(c, i);
      }
    }
  }
  return coefficients_from_integrals(integrals);
}

template <shape::Element S>
auto ProjectedDilatation<S>::coefficients_from_integrals(const Modes& integrals) const -> Modes {
  if (integrals.size() == 1) {
    return (1.0 / G(0, 0)) * integrals;
  }
  using Full = Eigen::Matrix<double, most_modes, most_modes>;
  return Full(G).inverse() * Eigen::Matrix<double, most_modes, 1>(integrals);
}

#define DILATATION(S) template struct ProjectedDilatation<S>;
SPRICKA_EACH_SHAPE(DILATATION)
DILATATION(shape::ReferenceElement<2>)
DILATATION(shape::ReferenceElement<3>)

} // namespace spricka::fe
