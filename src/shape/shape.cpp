// SPDX-License-Identifier: GPL-3.0-or-later
#include "shape/shape.hpp"

namespace spricka::shape {

Eigen::Matrix<double, 2, 1> Line2::N(const Point<1>& r) {
  return {0.5 * (1.0 - r[0]), 0.5 * (1.0 + r[0])};
}

Eigen::Matrix<double, 2, 1> Line2::dN(const Point<1>& /*r*/) {
  return {-0.5, 0.5};
}

Eigen::Matrix<double, 3, 1> Line3::N(const Point<1>& r) {
  const double x = r[0];
  return {0.5 * x * (x - 1.0), 0.5 * x * (x + 1.0), (1.0 - x) * (1.0 + x)};
}

Eigen::Matrix<double, 3, 1> Line3::dN(const Point<1>& r) {
  const double x = r[0];
  return {x - 0.5, x + 0.5, -2.0 * x};
}

Eigen::Matrix<double, 3, 1> Trim3::N(const Point<2>& r) {
  return {1.0 - r[0] - r[1], r[0], r[1]};
}

Eigen::Matrix<double, 3, 2> Trim3::dN(const Point<2>& /*r*/) {
  Eigen::Matrix<double, 3, 2> d;
  d << -1.0, -1.0, 1.0, 0.0, 0.0, 1.0;
  return d;
}

Eigen::Matrix<double, 6, 1> Trimc6::N(const Point<2>& r) {
  const double a = 1.0 - r[0] - r[1];
  const double b = r[0];
  const double c = r[1];
  Eigen::Matrix<double, 6, 1> n;
  n << a * (2.0 * a - 1.0), b * (2.0 * b - 1.0), c * (2.0 * c - 1.0), 4.0 * a * b, 4.0 * b * c,
      4.0 * c * a;
  return n;
}

Eigen::Matrix<double, 6, 2> Trimc6::dN(const Point<2>& r) {
  const double a = 1.0 - r[0] - r[1];
  const double b = r[0];
  const double c = r[1];
  Eigen::Matrix<double, 6, 2> d;
  d << 1.0 - 4.0 * a, 1.0 - 4.0 * a, 4.0 * b - 1.0, 0.0, 0.0, 4.0 * c - 1.0, 4.0 * (a - b),
      -4.0 * b, 4.0 * c, 4.0 * b, -4.0 * c, 4.0 * (a - c);
  return d;
}

Eigen::Matrix<double, 4, 1> Quam4::N(const Point<2>& r) {
  const double x = r[0];
  const double y = r[1];
  return {0.25 * (1.0 - x) * (1.0 - y), 0.25 * (1.0 + x) * (1.0 - y), 0.25 * (1.0 + x) * (1.0 + y),
          0.25 * (1.0 - x) * (1.0 + y)};
}

Eigen::Matrix<double, 4, 2> Quam4::dN(const Point<2>& r) {
  const double x = 0.25 * r[0];
  const double y = 0.25 * r[1];
  Eigen::Matrix<double, 4, 2> d;
  d << y - 0.25, x - 0.25, 0.25 - y, -0.25 - x, 0.25 + y, 0.25 + x, -0.25 - y, 0.25 - x;
  return d;
}

Eigen::Matrix<double, 8, 1> Quamc8::N(const Point<2>& r) {
  const double x = r[0];
  const double y = r[1];
  Eigen::Matrix<double, 8, 1> n;
  for (int i = 0; i < 4; ++i) {
    const double p = coordinates[static_cast<std::size_t>(i)][0];
    const double q = coordinates[static_cast<std::size_t>(i)][1];
    n[i] = 0.25 * (1.0 + p * x) * (1.0 + q * y) * (p * x + q * y - 1.0);
  }
  n[4] = 0.5 * (1.0 - x * x) * (1.0 - y);
  n[5] = 0.5 * (1.0 + x) * (1.0 - y * y);
  n[6] = 0.5 * (1.0 - x * x) * (1.0 + y);
  n[7] = 0.5 * (1.0 - x) * (1.0 - y * y);
  return n;
}

Eigen::Matrix<double, 8, 2> Quamc8::dN(const Point<2>& r) {
  const double x = r[0];
  const double y = r[1];
  Eigen::Matrix<double, 8, 2> d;
  for (int i = 0; i < 4; ++i) {
    const double p = coordinates[static_cast<std::size_t>(i)][0];
    const double q = coordinates[static_cast<std::size_t>(i)][1];
    d(i, 0) = 0.25 * p * (1.0 + q * y) * (2.0 * p * x + q * y);
    d(i, 1) = 0.25 * q * (1.0 + p * x) * (p * x + 2.0 * q * y);
  }
  d.bottomRows<4>() << -x * (1.0 - y), -0.5 * (1.0 - x * x), 0.5 * (1.0 - y * y), -y * (1.0 + x),
      -x * (1.0 + y), 0.5 * (1.0 - x * x), -0.5 * (1.0 - y * y), -y * (1.0 - x);
  return d;
}

Eigen::Matrix<double, 9, 1> Quamc9::N(const Point<2>& r) {
  const Eigen::Vector3d nx = Line3::N(Point<1>(r[0]));
  const Eigen::Vector3d ny = Line3::N(Point<1>(r[1]));
  Eigen::Matrix<double, 9, 1> n;
  for (int i = 0; i < 9; ++i) {
    const auto& f = factors[static_cast<std::size_t>(i)];
    n[i] = nx[f[0]] * ny[f[1]];
  }
  return n;
}

Eigen::Matrix<double, 9, 2> Quamc9::dN(const Point<2>& r) {
  const Eigen::Vector3d nx = Line3::N(Point<1>(r[0]));
  const Eigen::Vector3d ny = Line3::N(Point<1>(r[1]));
  const Eigen::Vector3d dx = Line3::dN(Point<1>(r[0]));
  const Eigen::Vector3d dy = Line3::dN(Point<1>(r[1]));
  Eigen::Matrix<double, 9, 2> d;
  for (int i = 0; i < 9; ++i) {
    const auto& f = factors[static_cast<std::size_t>(i)];
    d(i, 0) = dx[f[0]] * ny[f[1]];
    d(i, 1) = nx[f[0]] * dy[f[1]];
  }
  return d;
}

} // namespace spricka::shape
