// SPDX-License-Identifier: GPL-3.0-or-later
#include "shape/solid.hpp"

namespace spricka::shape {

Eigen::Matrix<double, 4, 1> Tet4::N(const Point<3>& r) {
  return {1.0 - r.sum(), r[0], r[1], r[2]};
}

Eigen::Matrix<double, 4, 3> Tet4::dN(const Point<3>& /*r*/) {
  Eigen::Matrix<double, 4, 3> d;
  d << -1.0, -1.0, -1.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0;
  return d;
}

Eigen::Matrix<double, 10, 1> Tet10::N(const Point<3>& r) {
  const Eigen::Vector4d l = Tet4::N(r);
  Eigen::Matrix<double, 10, 1> n;
  for (int i = 0; i < 4; ++i) {
    n[i] = l[i] * (2.0 * l[i] - 1.0);
  }
  for (int m = 0; m < 6; ++m) {
    const auto& [a, b] = edges[static_cast<std::size_t>(m)];
    n[4 + m] = 4.0 * l[a] * l[b];
  }
  return n;
}

Eigen::Matrix<double, 10, 3> Tet10::dN(const Point<3>& r) {
  const Eigen::Vector4d l = Tet4::N(r);
  const Eigen::Matrix<double, 4, 3> dl = Tet4::dN(r);
  Eigen::Matrix<double, 10, 3> d;
  for (int i = 0; i < 4; ++i) {
    d.row(i) = (4.0 * l[i] - 1.0) * dl.row(i);
  }
  for (int m = 0; m < 6; ++m) {
    const auto& [a, b] = edges[static_cast<std::size_t>(m)];
    d.row(4 + m) = 4.0 * (l[a] * dl.row(b) + l[b] * dl.row(a));
  }
  return d;
}

Eigen::Matrix<double, 6, 1> Penta6::N(const Point<3>& r) {
  const Eigen::Vector3d l = Trim3::N(r.head<2>());
  Eigen::Matrix<double, 6, 1> n;
  n << 0.5 * (1.0 - r[2]) * l, 0.5 * (1.0 + r[2]) * l;
  return n;
}

Eigen::Matrix<double, 6, 3> Penta6::dN(const Point<3>& r) {
  const Eigen::Vector3d l = Trim3::N(r.head<2>());
  const Eigen::Matrix<double, 3, 2> dl = Trim3::dN(r.head<2>());
  Eigen::Matrix<double, 6, 3> d;
  d << 0.5 * (1.0 - r[2]) * dl, -0.5 * l, 0.5 * (1.0 + r[2]) * dl, 0.5 * l;
  return d;
}

Eigen::Matrix<double, 15, 1> Pentac15::N(const Point<3>& r) {
  const Eigen::Vector3d l = Trim3::N(r.head<2>());
  Eigen::Matrix<double, 15, 1> n;
  for (int end = 0; end < 2; ++end) {
    const double qt = end == 0 ? -r[2] : r[2];
    for (int i = 0; i < 3; ++i) {
      n[3 * end + i] = 0.5 * l[i] * (1.0 + qt) * (2.0 * l[i] + qt - 2.0);
      n[6 + 3 * end + i] = 2.0 * l[i] * l[(i + 1) % 3] * (1.0 + qt);
    }
  }
  n.tail<3>() = (1.0 - r[2] * r[2]) * l;
  return n;
}

Eigen::Matrix<double, 15, 3> Pentac15::dN(const Point<3>& r) {
  const Eigen::Vector3d l = Trim3::N(r.head<2>());
  const Eigen::Matrix<double, 3, 2> dl = Trim3::dN(r.head<2>());
  Eigen::Matrix<double, 15, 3> d;
  for (int end = 0; end < 2; ++end) {
    const double q = end == 0 ? -1.0 : 1.0;
    const double qt = q * r[2];
    for (int i = 0; i < 3; ++i) {
      const int j = (i + 1) % 3;
      d.row(3 * end + i) << 0.5 * (1.0 + qt) * (4.0 * l[i] + qt - 2.0) * dl.row(i),
          0.5 * q * l[i] * (2.0 * l[i] + 2.0 * qt - 1.0);
      d.row(6 + 3 * end + i) << 2.0 * (1.0 + qt) * (l[i] * dl.row(j) + l[j] * dl.row(i)),
          2.0 * q * l[i] * l[j];
    }
  }
  d.bottomRows<3>() << (1.0 - r[2] * r[2]) * dl, -2.0 * r[2] * l;
  return d;
}

Eigen::Matrix<double, 8, 1> Hexe8::N(const Point<3>& r) {
  Eigen::Matrix<double, 8, 1> n;
  for (int i = 0; i < 8; ++i) {
    const auto& p = coordinates[static_cast<std::size_t>(i)];
    n[i] = 0.125 * (1.0 + p[0] * r[0]) * (1.0 + p[1] * r[1]) * (1.0 + p[2] * r[2]);
  }
  return n;
}

Eigen::Matrix<double, 8, 3> Hexe8::dN(const Point<3>& r) {
  Eigen::Matrix<double, 8, 3> d;
  for (int i = 0; i < 8; ++i) {
    const auto& p = coordinates[static_cast<std::size_t>(i)];
    const double x = 1.0 + p[0] * r[0];
    const double y = 1.0 + p[1] * r[1];
    const double z = 1.0 + p[2] * r[2];
    d.row(i) << 0.125 * p[0] * y * z, 0.125 * p[1] * x * z, 0.125 * p[2] * x * y;
  }
  return d;
}

Eigen::Matrix<double, 20, 1> Hexec20::N(const Point<3>& r) {
  Eigen::Matrix<double, 20, 1> n;
  for (int i = 0; i < nodes; ++i) {
    const Point<3> p = Eigen::Map<const Point<3>>(at(i).data());
    const Point<3> f = factors(p, r);
    n[i] = i < 8 ? 0.125 * f.prod() * (p.dot(r) - 2.0) : 0.25 * f.prod();
  }
  return n;
}

Eigen::Matrix<double, 20, 3> Hexec20::dN(const Point<3>& r) {
  Eigen::Matrix<double, 20, 3> d;
  for (int i = 0; i < nodes; ++i) {
    const Point<3> p = Eigen::Map<const Point<3>>(at(i).data());
    const Point<3> f = factors(p, r);
    const Point<3> others(f[1] * f[2], f[0] * f[2], f[0] * f[1]);
    for (int k = 0; k < 3; ++k) {
      const double slope = p[k] != 0.0 ? p[k] : -2.0 * r[k];
      d(i, k) =
          i < 8 ? 0.125 * p[k] * others[k] * (p.dot(r) - 2.0 + f[k]) : 0.25 * slope * others[k];
    }
  }
  return d;
}

Eigen::Matrix<double, 27, 1> Hexec27::N(const Point<3>& r) {
  const LineFactors line(r, Line3::N);
  Eigen::Matrix<double, 27, 1> n;
  for (int i = 0; i < nodes; ++i) {
    n[i] = line(i, 0) * line(i, 1) * line(i, 2);
  }
  return n;
}

Eigen::Matrix<double, 27, 3> Hexec27::dN(const Point<3>& r) {
  const LineFactors line(r, Line3::N);
  const LineFactors slope(r, Line3::dN);
  Eigen::Matrix<double, 27, 3> d;
  for (int i = 0; i < nodes; ++i) {
    d.row(i) << slope(i, 0) * line(i, 1) * line(i, 2), line(i, 0) * slope(i, 1) * line(i, 2),
        line(i, 0) * line(i, 1) * slope(i, 2);
  }
  return d;
}

} // namespace spricka::shape
