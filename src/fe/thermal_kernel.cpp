// SPDX-License-Identifier: GPL-3.0-or-later
#include "fe/thermal_kernel.hpp"

#include <Eigen/Cholesky>

namespace spricka::fe {

namespace {

// Whether an element's displacements hold all quadratic functions of x: its nodes are where its
// corners put them, those of a QUAMC8 on a parallelogram. Quarter-point elements do not.
template <shape::ElementShape S> bool holds_quadratics(const NodeVectors<S>& X) {
  const auto C = X.template leftCols<corners<S>()>();
  const double least = 1e-9 * (C.rowwise().maxCoeff() - C.rowwise().minCoeff()).norm();
  if constexpr (S::type == base::ElementType::quamc8) {
    if ((X.col(0) - X.col(1) + X.col(2) - X.col(3)).norm() > least) {
      return false;
    }
  }
  for (int n = corners<S>(); n < S::nodes; ++n) {
    if ((X.col(n) - C * Linear<S>::N(shape::node<S>(n))).norm() > least) {
      return false;
    }
  }
  return true;
}

} // namespace

template <shape::ElementShape S>
FreeExpansion<S>::FreeExpansion(const NodeVectors<S>& X, const Law& law, const CornerValues<S>& T)
    : centre_(X.template leftCols<corners<S>()>().rowwise().mean()),
      strain_(law.expansion * (law.heated_directions() * law.lambda + 2.0 * law.mu) /
              (2.0 * (law.lambda + law.mu))) {
  Eigen::Matrix<double, corners<S>(), 3> A;
  A.col(0).setOnes();
  A.template rightCols<2>() = (X.template leftCols<corners<S>()>().colwise() - centre_).transpose();
  // The plane through three corners, or the nearest to four.
  const Eigen::Matrix3d normal = A.transpose() * A;
  plane_ = normal.ldlt().solve(A.transpose() * T);
}

template <shape::ElementShape S>
bool FreeExpansion<S>::wanted(const NodeVectors<S>& X, const Law& law) {
  if constexpr (plane_quadratic<S>) {
    return !law.axisymmetric && !law.projected && !holds_quadratics<S>(X);
  }
  return false;
}

template <shape::ElementShape S>
base::Vec2 FreeExpansion<S>::displacement(const base::Vec2& x) const {
  const base::Vec2 d = x - centre_;
  const base::Vec2 g = slope();
  // (fe.38).
  const double square = 0.5 * (d.x() * d.x() - d.y() * d.y());
  const double product = d.x() * d.y();
  return strain_ * (plane_[0] * d +
                    base::Vec2(g.x() * square + g.y() * product, g.x() * product - g.y() * square));
}

template <shape::ElementShape S>
Eigen::Matrix2d FreeExpansion<S>::gradient(const base::Vec2& x) const {
  const base::Vec2 d = x - centre_;
  const double turn = slope().y() * d.x() - slope().x() * d.y();
  const double T = temperature(x);
  Eigen::Matrix2d H;
  // The same strain in all directions, no shear, and a rotation.
  H << T, turn, -turn, T;
  return strain_ * H;
}

template <shape::ElementShape S>
NodeVectors<S> FreeExpansion<S>::at_nodes(const NodeVectors<S>& X) const {
  NodeVectors<S> U;
  for (int n = 0; n < S::nodes; ++n) {
    U.col(n) = displacement(X.col(n));
  }
  return U;
}

template <shape::ElementShape S> HeatFunctions<S>::HeatFunctions(const NodeVectors<S>& X) : X_(X) {
  if constexpr (bent) {
    const auto C = X.template leftCols<corners<S>()>();
    const Eigen::Matrix<double, corners<S>(), S::dim> A =
        (C.colwise() - C.rowwise().mean()).transpose();
    const Eigen::Matrix<double, S::dim, S::dim> normal = A.transpose() * A;
    slope_ = normal.ldlt().solve(A.transpose()).transpose();
  } else {
    slope_.setZero();
  }
}

template <shape::ElementShape S>
CornerValues<S> HeatFunctions<S>::at(const shape::Point<S::dim>& r) const {
  CornerValues<S> L = Linear<S>::N(r);
  if constexpr (bent) {
    // How far a point is from where the corners put it.
    return L + slope_ * (X_ * S::N(r) - X_.template leftCols<corners<S>()>() * L);
  }
  return L;
}

template <shape::ElementShape S>
Eigen::Matrix<double, corners<S>(), S::dim>
HeatFunctions<S>::gradients(const Jacobian<S>& at, const shape::Point<S::dim>& r) const {
  Eigen::Matrix<double, corners<S>(), S::dim> G = Linear<S>::dN(r) * at.J.inverse();
  if constexpr (bent) {
    return G + slope_ * (Eigen::Matrix<double, S::dim, S::dim>::Identity() -
                         X_.template leftCols<corners<S>()>() * G);
  }
  return G;
}

template <shape::ElementShape S>
ThermalStress<S>::ThermalStress(const NodeVectors<S>& X, const Law& law_, const CornerValues<S>& T_)
    : law(law_), T(T_), functions(X) {
  if (!law.projected || (T.array() == 0.0).all()) {
    return;
  }
  typename Dilatation<S>::Modes right = Dilatation<S>::Modes::Zero();
  for (const auto& point : stiffness_rule<S>(law)) {
    const Hoop<S> hoop(X, law, point.r);
    const double w = point.weight * jacobian<S>(X, point.r).det * law.depth(hoop.x);
    right += (w * temperature(point.r)) * Dilatation<S>::phi(point.r);
  }
  // As the volume change (fe.12): what drives it must be of the same functions.
  projected = Dilatation<S>(X, law).G.inverse() * right;
}

template <shape::ElementShape S>
NodeVectors<S> thermal_forces(const NodeVectors<S>& X, const Law& law, const CornerValues<S>& T) {
  if constexpr (plane_quadratic<S>) {
    if (FreeExpansion<S>::wanted(X, law)) {
      // F = K_e u_T of (fe.38).
      return element_force<S>(X, law, FreeExpansion<S>(X, law, T).at_nodes(X));
    }
  }
  const ThermalStress<S> stress(X, law, T);
  NodeVectors<S> F = NodeVectors<S>::Zero();
  for (const auto& point : stiffness_rule<S>(law)) {
    const Jacobian<S> at = jacobian<S>(X, point.r);
    const Hoop<S> hoop(X, law, point.r);
    // (fe.22).
    const double w = point.weight * at.det * law.depth(hoop.x) * stress.at(point.r);
    F.noalias() += w * at.dNdx.transpose();
    F.row(0) += w * hoop.h.transpose();
  }
  return F;
}

#define EXPANSION(S) template class FreeExpansion<S>;
SPRICKA_EACH_PLANE_SHAPE(EXPANSION)

#define THERMAL(S)                                                                                 \
  template class HeatFunctions<S>;                                                                 \
  template struct ThermalStress<S>;                                                                \
  template NodeVectors<S> thermal_forces<S>(const NodeVectors<S>&, const Law&,                     \
                                            const CornerValues<S>&);
SPRICKA_EACH_SHAPE(THERMAL)

} // namespace spricka::fe
