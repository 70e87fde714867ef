// SPDX-License-Identifier: GPL-3.0-or-later
#include "fe/element.hpp"

namespace spricka::fe {

template <shape::Element S>
NodeVectors<S> element_force(const S& element, const NodeVectors<S>& X, const ConstitutiveLaw& law,
                             const NodeVectors<S>& U) {
  using Square = Eigen::Matrix<double, S::dim, S::dim>;
  NodeVectors<S> F = NodeVectors<S>::Zero(S::dim, element.nodes);
  const VolumeChangeField<S> change(element, X, law, U);
  for (const auto& point : stiffness_rule(element, law)) {
    const Gradients<S> dN = element.dN(point.r);
    const Square J = X.lazyProduct(dN); // as in jacobian.cpp
    const Square J_inverse = J.inverse();
    const HoopStrain<S> hoop(element, X, law, point.r);
    const double w = point.weight * J.determinant() * law.depth(hoop.x);
    const Square H = U.lazyProduct(dN).eval() * J_inverse;
    const double ring = law.is_axisymmetric<S::dim>() ? double(U.row(0) * hoop.h) : 0.0;
    // (fe.11); dN/dx is not formed: T (dN/dx)^T = T J^-T dN^T.
    const double pressure = law.lambda * change.at(point.r, H.trace() + ring);
    Square T = law.mu * (H + H.transpose());
    T.diagonal().array() += pressure;
    const Square flow = w * T * J_inverse.transpose();
    F.noalias() += flow * dN.transpose();
    if (law.is_axisymmetric<S::dim>()) {
      F.row(0) += (w * (pressure + 2.0 * law.mu * ring)) * hoop.h.transpose();
    }
  }
  return F;
}

#define FORCE(S)                                                                                   \
  template NodeVectors<S> element_force<S>(const S&, const NodeVectors<S>&,                        \
                                           const ConstitutiveLaw&, const NodeVectors<S>&);
SPRICKA_EACH_SHAPE(FORCE)
FORCE(shape::ReferenceElement<2>)
FORCE(shape::ReferenceElement<3>)

} // namespace spricka::fe
