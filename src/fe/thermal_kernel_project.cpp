// SPDX-License-Identifier: GPL-3.0-or-later
#include "fe/thermal_kernel.hpp"

#include <Eigen/Cholesky>

namespace spricka::fe {

namespace {

template <shape::ElementShape S> using Rule = std::span<const shape::QuadraturePoint<S::dim>>;

// Corner values of the function in the span of f(x, functions of the corners) that comes nearest to
// a temperature field(x) at the points of a rule.
template <shape::ElementShape S, int terms, class Functions>
CornerValues<S> nearest_temperature(const NodeVectors<S>& X, const Law& law, const Rule<S>& rule,
                                    const Temperature<S>& field, const Functions& functions) {
  const HeatFunctions<S> heat(X);
  Eigen::Matrix<double, terms, terms> G;
  G.setZero();
  Eigen::Matrix<double, terms, 1> right = Eigen::Matrix<double, terms, 1>::Zero();
  for (const auto& point : rule) {
    const Eigen::Matrix<double, S::dim, 1> x = X * S::N(point.r);
    const double w = point.weight * jacobian<S>(X, point.r).det * law.depth(x[0]);
    const Eigen::Matrix<double, terms, 1> f = functions(x, heat.at(point.r));
    G.noalias() += (w * f) * f.transpose();
    right += (w * field(x)) * f;
  }
  const Eigen::Matrix<double, terms, 1> c = G.ldlt().solve(right);
  CornerValues<S> T;
  for (int n = 0; n < corners<S>(); ++n) {
    T[n] = c.dot(functions(X.col(n), heat.at(shape::node<S>(n))));
  }
  return T;
}

} // namespace

template <shape::ElementShape S>
CornerValues<S> project_temperature(const NodeVectors<S>& X, const Law& law,
                                    std::span<const shape::QuadraturePoint<S::dim>> rule,
                                    const Temperature<S>& field) {
  using Place = Eigen::Matrix<double, S::dim, 1>;
  if constexpr (!base::info(S::type).quadratic) {
    return nearest_temperature<S, 1>(X, law, rule, field, [](const Place&, const CornerValues<S>&) {
      // The mean (fe.23).
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

#define PROJECT(S)                                                                                 \
  template CornerValues<S> project_temperature<S>(const NodeVectors<S>&, const Law&,               \
                                                  std::span<const shape::QuadraturePoint<S::dim>>, \
                                                  const Temperature<S>&);
SPRICKA_EACH_SHAPE(PROJECT)

} // namespace spricka::fe
