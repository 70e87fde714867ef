// SPDX-License-Identifier: GPL-3.0-or-later
#include "fe/dilatation.hpp"

#include <Eigen/LU>

namespace spricka::fe {

template <shape::ElementShape S>
Dilatation<S>::Dilatation(const NodeVectors<S>& X, const Law& law) {
  // (fe.14), by the rule of the stiffness, which the projection is a part of.
  for (const auto& point : stiffness_rule<S>(law)) {
    const Jacobian<S> at = jacobian<S>(X, point.r);
    const Hoop<S> hoop(X, law, point.r);
    const double w = point.weight * at.det * law.depth(hoop.x);
    const Modes p = phi(point.r);
    Eigen::Matrix<double, 1, S::dim * S::nodes> theta;
    for (int i = 0; i < S::nodes; ++i) {
      theta.template segment<S::dim>(S::dim * i) = at.dNdx.row(i);
      theta[S::dim * i] += hoop.h[i];
    }
    C.noalias() += (w * p) * theta;
    G.noalias() += (w * p) * p.transpose();
  }
}

template <shape::ElementShape S>
auto Dilatation<S>::of(const Eigen::Matrix<double, S::dim * S::nodes, 1>& u) const -> Modes {
  return G.inverse() * (C * u);
}

#define DILATATION(S) template struct Dilatation<S>;
SPRICKA_EACH_SHAPE(DILATATION)

} // namespace spricka::fe
