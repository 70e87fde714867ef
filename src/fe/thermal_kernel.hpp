// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "fe/element.hpp"

#include <Eigen/Cholesky>

#include <type_traits>

namespace spricka::fe {

template <shape::ElementShape S> constexpr int corners() {
  return base::info(S::type).corners;
}

/// The linear element with the same corners.
template <shape::ElementShape S>
using Linear = std::conditional_t<
    S::dim == 2, std::conditional_t<corners<S>() == 3, shape::Trim3, shape::Quam4>,
    std::conditional_t<corners<S>() == 4, shape::Tet4,
                       std::conditional_t<corners<S>() == 6, shape::Penta6, shape::Hexe8>>>;

/// Values at the corners of an element; between them its linear relative interpolates.
template <shape::ElementShape S> using CornerValues = Eigen::Matrix<double, corners<S>(), 1>;

/// Corner temperatures of an element out of a field by connectivity index.
template <shape::ElementShape S>
CornerValues<S> corner_temperature(const model::Mesh& mesh, base::ElementId e,
                                   const base::Vector& temperature) {
  return temperature.template segment<corners<S>()>(mesh.first[e.index()]);
}

template <shape::ElementShape S>
inline constexpr bool plane_quadratic = S::dim == 2 && base::info(S::type).quadratic;

/// Whether an element's displacements hold all quadratic functions of x: its nodes are where its
/// corners put them, those of a QUAMC8 on a parallelogram. Quarter-point elements do not.
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

/// A temperature that is linear in x in a plane element, and the displacement it drives where
/// nothing holds the element, which strains it the same in all directions. Quadratic elements that
/// do not hold quadratic functions cannot follow it: in them it is taken out beforehand and the
/// nodes bear the rest, which leaves no stress of a linear temperature in any element.
template <shape::ElementShape S> class FreeExpansion {
public:
  FreeExpansion() = default; ///< of nothing
  /// Of corner values that lie on a plane, or of the plane nearest to them.
  FreeExpansion(const NodeVectors<S>& X, const Law& law, const CornerValues<S>& T)
      : centre_(X.template leftCols<corners<S>()>().rowwise().mean()),
        strain_(law.expansion * (law.heated_directions() * law.lambda + 2.0 * law.mu) /
                (2.0 * (law.lambda + law.mu))) {
    Eigen::Matrix<double, corners<S>(), 3> A;
    A.col(0).setOnes();
    A.template rightCols<2>() =
        (X.template leftCols<corners<S>()>().colwise() - centre_).transpose();
    const Eigen::Matrix3d normal = A.transpose() * A;
    plane_ = normal.ldlt().solve(A.transpose() * T);
  }
  [[nodiscard]] static bool wanted(const NodeVectors<S>& X, const Law& law) {
    if constexpr (plane_quadratic<S>) {
      return !law.axisymmetric && !law.projected && !holds_quadratics<S>(X);
    }
    return false;
  }
  [[nodiscard]] double temperature(const base::Vec2& x) const {
    return plane_[0] + plane_.template tail<2>().dot(x - centre_);
  }
  [[nodiscard]] base::Vec2 slope() const { return plane_.template tail<2>(); }
  [[nodiscard]] base::Vec2 displacement(const base::Vec2& x) const {
    const base::Vec2 d = x - centre_;
    const base::Vec2 g = slope();
    const double square = 0.5 * (d.x() * d.x() - d.y() * d.y());
    const double product = d.x() * d.y();
    return strain_ * (plane_[0] * d + base::Vec2(g.x() * square + g.y() * product,
                                                 g.x() * product - g.y() * square));
  }
  [[nodiscard]] Eigen::Matrix2d gradient(const base::Vec2& x) const {
    const base::Vec2 d = x - centre_;
    const double turn = slope().y() * d.x() - slope().x() * d.y();
    const double T = temperature(x);
    Eigen::Matrix2d H;
    H << T, turn, -turn, T;
    return strain_ * H;
  }
  [[nodiscard]] NodeVectors<S> at_nodes(const NodeVectors<S>& X) const {
    NodeVectors<S> U;
    for (int n = 0; n < S::nodes; ++n) {
      U.col(n) = displacement(X.col(n));
    }
    return U;
  }

private:
  base::Vec2 centre_ = base::Vec2::Zero();
  double strain_ = 0.0; ///< of a temperature of 1
  Eigen::Vector3d plane_ = Eigen::Vector3d::Zero();
};

/// What a temperature T takes out of the normal stresses of an element: a body held all round
/// carries -alpha (3 lambda T + 2 mu T); in plane stress, with the reduced lambda, two directions
/// are held. Where the volume change is projected, so is the temperature that drives it: a body
/// free to expand would keep stresses else.
template <shape::ElementShape S> struct ThermalStress {
  const Law& law;
  CornerValues<S> T;
  typename Dilatation<S>::Modes projected = Dilatation<S>::Modes::Zero();

  ThermalStress(const NodeVectors<S>& X, const Law& law_, const CornerValues<S>& T_)
      : law(law_), T(T_) {
    if (!law.projected || (T.array() == 0.0).all()) {
      return;
    }
    typename Dilatation<S>::Modes right = Dilatation<S>::Modes::Zero();
    for (const auto& point : stiffness_rule<S>(law)) {
      const Hoop<S> hoop(X, law, point.r);
      const double w = point.weight * jacobian<S>(X, point.r).det * law.depth(hoop.x);
      right += (w * temperature(point.r)) * Dilatation<S>::phi(point.r);
    }
    projected = Dilatation<S>(X, law).G.inverse() * right;
  }
  [[nodiscard]] double temperature(const shape::Point<S::dim>& r) const {
    return T.dot(Linear<S>::N(r));
  }
  /// The temperature that drives the volume change.
  [[nodiscard]] double of_volume(const shape::Point<S::dim>& r) const {
    return law.projected ? Dilatation<S>::phi(r).dot(projected) : temperature(r);
  }
  [[nodiscard]] double at(const shape::Point<S::dim>& r) const {
    return law.expansion *
           (law.heated_directions() * law.lambda * of_volume(r) + 2.0 * law.mu * temperature(r));
  }
};

/// Corner values of the function in the span of f(x, N of the corners) that comes nearest to a
/// temperature field(x) at the points of a rule.
template <shape::ElementShape S, int terms, class Rule, class Field, class Functions>
CornerValues<S> nearest_temperature(const NodeVectors<S>& X, const Law& law, const Rule& rule,
                                    const Field& field, const Functions& functions) {
  Eigen::Matrix<double, terms, terms> G;
  G.setZero();
  Eigen::Matrix<double, terms, 1> right = Eigen::Matrix<double, terms, 1>::Zero();
  for (const auto& point : rule) {
    const Eigen::Matrix<double, S::dim, 1> x = X * S::N(point.r);
    const double w = point.weight * jacobian<S>(X, point.r).det * law.depth(x[0]);
    const Eigen::Matrix<double, terms, 1> f = functions(x, Linear<S>::N(point.r));
    G.noalias() += (w * f) * f.transpose();
    right += (w * field(x)) * f;
  }
  const Eigen::Matrix<double, terms, 1> c = G.ldlt().solve(right);
  CornerValues<S> T;
  for (int n = 0; n < corners<S>(); ++n) {
    T[n] = c.dot(functions(X.col(n), Linear<S>::N(shape::node<S>(n))));
  }
  return T;
}

/// A temperature field(x) as an element takes it: constant in linear elements, linear in the
/// reference coordinates of quadratic ones, and in x where these do not hold quadratic functions.
template <shape::ElementShape S, class Rule, class Field>
CornerValues<S> project_temperature(const NodeVectors<S>& X, const Law& law, const Rule& rule,
                                    const Field& field) {
  using Place = Eigen::Matrix<double, S::dim, 1>;
  if constexpr (!base::info(S::type).quadratic) {
    return nearest_temperature<S, 1>(X, law, rule, field, [](const Place&, const CornerValues<S>&) {
      return Eigen::Matrix<double, 1, 1>::Constant(1.0);
    });
  } else {
    if constexpr (plane_quadratic<S>) {
      if (FreeExpansion<S>::wanted(X, law)) {
        const Place centre = X.template leftCols<corners<S>()>().rowwise().mean();
        return nearest_temperature<S, 3>(
            X, law, rule, field, [&](const Place& x, const CornerValues<S>&) {
              return Eigen::Vector3d(1.0, x[0] - centre[0], x[1] - centre[1]);
            });
      }
    }
    return nearest_temperature<S, corners<S>()>(
        X, law, rule, field, [](const Place&, const CornerValues<S>& N) { return N; });
  }
}

/// Consistent forces of an element's temperatures.
template <shape::ElementShape S>
NodeVectors<S> thermal_forces(const NodeVectors<S>& X, const Law& law, const CornerValues<S>& T) {
  if constexpr (plane_quadratic<S>) {
    if (FreeExpansion<S>::wanted(X, law)) {
      return element_force<S>(X, law, FreeExpansion<S>(X, law, T).at_nodes(X));
    }
  }
  const ThermalStress<S> stress(X, law, T);
  NodeVectors<S> F = NodeVectors<S>::Zero();
  for (const auto& point : stiffness_rule<S>(law)) {
    const Jacobian<S> at = jacobian<S>(X, point.r);
    const Hoop<S> hoop(X, law, point.r);
    const double w = point.weight * at.det * law.depth(hoop.x) * stress.at(point.r);
    F.noalias() += w * at.dNdx.transpose();
    F.row(0) += w * hoop.h.transpose();
  }
  return F;
}

} // namespace spricka::fe
