// SPDX-License-Identifier: GPL-3.0-or-later
#include "estimate/space_modes.hpp"

#include "shape/solid.hpp"
#include "shape/topology.hpp"

#include <algorithm>
#include <cassert>
#include <type_traits>

namespace spricka::estimate {

namespace {

using base::ElementType;
using base::Vec3;

/// A function of the reference coordinates with its gradient at a point.
struct Jet {
  double value = 0.0;
  Vec3 slope = Vec3::Zero();
};
Jet operator+(const Jet& a, const Jet& b) {
  return {a.value + b.value, a.slope + b.slope};
}
Jet operator-(const Jet& a, const Jet& b) {
  return {a.value - b.value, a.slope - b.slope};
}
Jet operator*(const Jet& a, const Jet& b) {
  return {a.value * b.value, a.value * b.slope + b.value * a.slope};
}
Jet operator*(double f, const Jet& a) {
  return {f * a.value, f * a.slope};
}

// A mode is written once, for `Number` = Jet and, where no gradient is asked for, double.
template <class Number> Number number(double f) {
  if constexpr (std::is_same_v<Number, Jet>) {
    return {f, Vec3::Zero()};
  } else {
    return f;
  }
}
template <class Number> Number one_less_square(const Number& t) {
  return number<Number>(1.0) - t * t;
}
// L_i L_j (L_i - L_j) along an edge, as t from its first to its second corner has it (estimate.7).
template <class Number> Number along_edge(const Number& t) {
  return -0.25 * (t * one_less_square(t));
}

template <class Number> std::array<Number, 3> coordinates(const Vec3& r) {
  if constexpr (std::is_same_v<Number, Jet>) {
    return {Jet{r[0], Vec3::UnitX()}, Jet{r[1], Vec3::UnitY()}, Jet{r[2], Vec3::UnitZ()}};
  } else {
    return {r[0], r[1], r[2]};
  }
}

// b {1, u, w, u w}
template <class Number>
Number on_quadrilateral(const Number& bubble, const Number& u, const Number& w, int which) {
  switch (which) {
  case 0:
    return bubble;
  case 1:
    return bubble * u;
  case 2:
    return bubble * w;
  default:
    return bubble * (u * w);
  }
}

template <class Number> Number tetrahedron(const SolidMode& mode, const Vec3& r) {
  const auto x = coordinates<Number>(r);
  const std::array<Number, 4> L{number<Number>(1.0) - x[0] - x[1] - x[2], x[0], x[1], x[2]};
  if (mode.on == SolidMode::SolidModeSite::edge) {
    const auto [i, j] = shape::edge_corners(ElementType::tet10, mode.which);
    const Number& a = L[static_cast<std::size_t>(i)];
    const Number& b = L[static_cast<std::size_t>(j)];
    return a * b * (a - b);
  }
  Number product = number<Number>(1.0);
  for (const int k : shape::side_nodes(ElementType::tet10, mode.which).first(3)) {
    product = product * L[static_cast<std::size_t>(k)];
  }
  return product;
}

template <class Number> Number wedge(const SolidMode& mode, const Vec3& r) {
  const auto x = coordinates<Number>(r);
  const std::array<Number, 3> l{number<Number>(1.0) - x[0] - x[1], x[0], x[1]};
  const Number& z = x[2];
  const auto end = [&](bool upper) {
    return 0.5 * (number<Number>(1.0) + (upper ? 1.0 : -1.0) * z);
  };
  const Number triple = l[0] * l[1] * l[2];
  switch (mode.on) {
  case SolidMode::SolidModeSite::edge: {
    const auto [i, j] = shape::edge_corners(ElementType::pentac15, mode.which);
    const Number& a = l[static_cast<std::size_t>(i % 3)];
    const Number& b = l[static_cast<std::size_t>(j % 3)];
    return mode.which < 6 ? a * b * (a - b) * end(mode.which >= 3) : a * along_edge(z);
  }
  case SolidMode::SolidModeSite::triangle:
    return triple * end(mode.which == 1);
  case SolidMode::SolidModeSite::quadrilateral: {
    const auto corners = shape::side_nodes(ElementType::pentac15, mode.which);
    const Number& a = l[static_cast<std::size_t>(corners[0] % 3)];
    const Number& b = l[static_cast<std::size_t>(corners[1] % 3)];
    return on_quadrilateral(4.0 * (a * b * one_less_square(z)), b - a, z, mode.number);
  }
  default:
    return mode.number == 0 ? triple * one_less_square(z) : triple * one_less_square(z) * z;
  }
}

template <class Number> Number hexahedron(const SolidMode& mode, const Vec3& r) {
  const auto x = coordinates<Number>(r);
  const auto corner = [](int k) {
    return Vec3(
        Eigen::Map<const Vec3>(shape::Hexec20::coordinates[static_cast<std::size_t>(k)].data()));
  };
  // From the corner p to the corner q along a coordinate, -1 to 1.
  const auto way = [&](int p, int q) {
    const Vec3 step = corner(q) - corner(p);
    Number t = number<Number>(0.0);
    for (int k = 0; k < 3; ++k) {
      t = t + 0.5 * step[k] * x[static_cast<std::size_t>(k)];
    }
    return t;
  };
  // 1 on the sides of corner p, 0 opposite, but for the directions left out.
  const auto at = [&](int p, const Vec3& without) {
    Number product = number<Number>(1.0);
    for (int k = 0; k < 3; ++k) {
      if (without[k] == 0.0) {
        product =
            product * (0.5 * (number<Number>(1.0) + corner(p)[k] * x[static_cast<std::size_t>(k)]));
      }
    }
    return product;
  };
  switch (mode.on) {
  case SolidMode::SolidModeSite::edge: {
    const auto [p, q] = shape::edge_corners(ElementType::hexec20, mode.which);
    return along_edge(way(p, q)) * at(p, corner(q) - corner(p));
  }
  case SolidMode::SolidModeSite::quadrilateral: {
    const auto corners = shape::side_nodes(ElementType::hexec20, mode.which);
    const Number u = way(corners[0], corners[1]);
    const Number w = way(corners[0], corners[3]);
    const Number bubble = one_less_square(u) * one_less_square(w) *
                          at(corners[0], corner(corners[2]) - corner(corners[0]));
    return on_quadrilateral(bubble, u, w, mode.number);
  }
  default: {
    const Number bubble = one_less_square(x[0]) * one_less_square(x[1]) * one_less_square(x[2]);
    return mode.number == 0 ? bubble : bubble * x[static_cast<std::size_t>(mode.number - 1)];
  }
  }
}

template <class Number>
Number evaluate_mode(ElementType type, const SolidMode& mode, const Vec3& r) {
  switch (type) {
  case ElementType::tet10:
    return tetrahedron<Number>(mode, r);
  case ElementType::pentac15:
    return wedge<Number>(mode, r);
  default:
    assert(type == ElementType::hexec20);
    return hexahedron<Number>(mode, r);
  }
}

} // namespace

bool SolidModes::has_modes_for_type(ElementType type) {
  return type == ElementType::tet10 || type == ElementType::pentac15 ||
         type == ElementType::hexec20;
}

const SolidModes& SolidModes::for_type(ElementType type) {
  static const SolidModes tet(ElementType::tet10);
  static const SolidModes penta(ElementType::pentac15);
  static const SolidModes hexa(ElementType::hexec20);
  assert(has_modes_for_type(type));
  return type == ElementType::tet10 ? tet : type == ElementType::pentac15 ? penta : hexa;
}

SolidModes::SolidModes(ElementType type) : type_(type) {
  for (int m = 0; m < shape::edge_count(type); ++m) {
    modes_.push_back({SolidMode::SolidModeSite::edge, m, 0});
  }
  for (int s = 0; s < base::element_info(type).sides; ++s) {
    if (shape::side_corner_count(type, s) == 3) {
      modes_.push_back({SolidMode::SolidModeSite::triangle, s, 0});
    } else {
      for (int k = 0; k < 4; ++k) {
        modes_.push_back({SolidMode::SolidModeSite::quadrilateral, s, k});
      }
    }
  }
  const int inside = type == ElementType::tet10 ? 0 : type == ElementType::pentac15 ? 2 : 4;
  for (int k = 0; k < inside; ++k) {
    modes_.push_back({SolidMode::SolidModeSite::inside, 0, k});
  }
}

base::Vector SolidModes::psi(const Vec3& r) const {
  base::Vector values(static_cast<Eigen::Index>(modes_.size()));
  for (std::size_t m = 0; m < modes_.size(); ++m) {
    values[static_cast<Eigen::Index>(m)] = evaluate_mode<double>(type_, modes_[m], r);
  }
  return values;
}

Eigen::MatrixX3d SolidModes::dpsi(const Vec3& r) const {
  Eigen::MatrixX3d slopes(static_cast<Eigen::Index>(modes_.size()), 3);
  for (std::size_t m = 0; m < modes_.size(); ++m) {
    slopes.row(static_cast<Eigen::Index>(m)) =
        evaluate_mode<Jet>(type_, modes_[m], r).slope.transpose();
  }
  return slopes;
}

FaceModeAxes face_mode_axes(const std::array<base::NodeId, 4>& corners) {
  // u and w at the corners of the element's own axes.
  static constexpr std::array<std::array<double, 2>, 4> at{
      {{-1.0, -1.0}, {1.0, -1.0}, {1.0, 1.0}, {-1.0, 1.0}}};
  const auto start = static_cast<std::size_t>(std::ranges::min_element(corners) - corners.begin());
  const std::size_t next = (start + 1) % 4;
  const std::size_t last = (start + 3) % 4;
  const std::size_t first = corners[next] < corners[last] ? next : last;
  // The common first axis runs from start to first, along the own axis `own`.
  const std::size_t own = at[first][0] != at[start][0] ? 0 : 1;
  const std::array<double, 2> sign{-at[start][0], -at[start][1]};
  FaceModeAxes axes;
  axes.number = {0, own == 0 ? 1 : 2, own == 0 ? 2 : 1, 3};
  axes.sign = {1.0, sign[0], sign[1], sign[0] * sign[1]};
  return axes;
}

} // namespace spricka::estimate
