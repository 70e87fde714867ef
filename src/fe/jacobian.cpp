// SPDX-License-Identifier: GPL-3.0-or-later
#include "fe/jacobian.hpp"

namespace spricka::fe {

template <shape::Element S>
Jacobian<S> jacobian(const S& element, const NodeVectors<S>& X, const shape::Point<S::dim>& r) {
  return jacobian_by_derivatives<S>(X, element.dN(r));
}

template <shape::Element S>
Jacobian<S> jacobian_by_derivatives(const NodeVectors<S>& X, const Gradients<S>& dN) {
  Jacobian<S> at;
  // Eigen would pack such small matrices for a product of large ones.
  at.J = X.lazyProduct(dN);
  at.det = at.J.determinant();
  const Eigen::Matrix<double, S::dim, S::dim> inverse = at.J.inverse();
  at.dNdx = dN.lazyProduct(inverse);
  return at;
}

#define JACOBIAN(S)                                                                                \
  template Jacobian<S> jacobian_by_derivatives<S>(const NodeVectors<S>&, const Gradients<S>&);     \
  template Jacobian<S> jacobian<S>(const S&, const NodeVectors<S>&, const shape::Point<S::dim>&);
SPRICKA_EACH_SHAPE(JACOBIAN)
JACOBIAN(shape::ReferenceElement<2>)
JACOBIAN(shape::ReferenceElement<3>)

} // namespace spricka::fe
