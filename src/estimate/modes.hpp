// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "shape/shape.hpp"

#include <type_traits>

/// Hierarchical modes that raise quadratic plane elements to complete cubics (manual, estimate.5 to
/// 7): zero at all nodes of the element, so that adding them leaves nodal displacements what they
/// are. One mode for each side, psi = L_i L_j (L_i - L_j) on its side from corner i = s to j = s +
/// 1 and zero on the others (the same along a side of a triangle and of a quadrilateral), then
/// interior modes that vanish on all sides. Hierarchical shapes: Szabo and Babuska 1991.
namespace spricka::estimate {

/// psi(r) [count] and dpsi(r) [count, 2] by reference coordinates; side_coordinate(r, s) runs from
/// -1 to 1 on side s from its first to its second corner, side_coordinate_gradient(s) is its
/// gradient.
struct TriangleModes {
  static constexpr int sides = 3;
  static constexpr int count = 4;
  /// Psi of the enriched stiffness has degree 4 on straight sides; curved and quarter-point ones
  /// are rational.
  static constexpr int degree = 6;

  /// The three area coordinates of a point of the triangle; L_0 belongs to the corner at r = 0.
  static Eigen::Vector3d area_coordinates(const shape::Point<2>& r) {
    return {1.0 - r[0] - r[1], r[0], r[1]};
  }
  /// Gradients of the area coordinates by the reference coordinates, the same at all points.
  static const Eigen::Matrix<double, 3, 2>& area_coordinate_gradients() {
    static const Eigen::Matrix<double, 3, 2> d{{-1.0, -1.0}, {1.0, 0.0}, {0.0, 1.0}};
    return d;
  }
  /// Values of the modes at a point: three of the sides, then the interior bubble. [count]
  static Eigen::Matrix<double, count, 1> psi(const shape::Point<2>& r) {
    const Eigen::Vector3d L = area_coordinates(r);
    Eigen::Matrix<double, count, 1> value;
    for (int s = 0; s < sides; ++s) {
      const double a = L[s];
      const double b = L[(s + 1) % 3];
      value[s] = a * b * (a - b);
    }
    value[3] = L[0] * L[1] * L[2];
    return value;
  }
  /// Derivatives of the modes by the reference coordinates. [count, 2]
  static Eigen::Matrix<double, count, 2> dpsi(const shape::Point<2>& r) {
    const Eigen::Vector3d L = area_coordinates(r);
    const Eigen::Matrix<double, 3, 2>& d = area_coordinate_gradients();
    Eigen::Matrix<double, count, 2> slope;
    for (int s = 0; s < sides; ++s) {
      const int j = (s + 1) % 3;
      const double a = L[s];
      const double b = L[j];
      slope.row(s) = b * (2.0 * a - b) * d.row(s) + a * (a - 2.0 * b) * d.row(j);
    }
    slope.row(3) = L[1] * L[2] * d.row(0) + L[2] * L[0] * d.row(1) + L[0] * L[1] * d.row(2);
    return slope;
  }
  /// Coordinate along side s, -1 at its first corner and 1 at its second.
  static double side_coordinate(const shape::Point<2>& r, int s) {
    const Eigen::Vector3d L = area_coordinates(r);
    return L[(s + 1) % 3] - L[s];
  }
  /// Gradient of the side coordinate by the reference coordinates, the same at all points.
  static Eigen::RowVector2d side_coordinate_gradient(int s) {
    return area_coordinate_gradients().row((s + 1) % 3) - area_coordinate_gradients().row(s);
  }
};

/// Sides, then (1 - x^2)(1 - y^2) times x, y, xy and, for the element without a centre node, 1:
/// with either element all products of cubics.
template <bool centre> struct QuadrilateralModes {
  static constexpr int sides = 4;
  static constexpr int inner = centre ? 3 : 4;
  static constexpr int count = sides + inner;
  static constexpr int degree = 7;

  // (1 - t^2) t (1 + p n) / -8 with t along the side and n across, p = -1 or 1 where the side lies.
  struct SideAxes {
    int along;    ///< which coordinate runs along the side
    double turn;  ///< the way it runs
    double place; ///< where the other one is
  };
  static constexpr std::array<SideAxes, 4> axes{
      {{0, 1.0, -1.0}, {1, 1.0, 1.0}, {0, -1.0, 1.0}, {1, -1.0, -1.0}}};

  /// Values of the modes at a point: four of the sides, then those of the interior. [count]
  static Eigen::Matrix<double, count, 1> psi(const shape::Point<2>& r) {
    Eigen::Matrix<double, count, 1> value;
    for (int s = 0; s < sides; ++s) {
      const SideAxes& a = axes[static_cast<std::size_t>(s)];
      const double t = a.turn * r[a.along];
      value[s] = -0.125 * t * (1.0 - t * t) * (1.0 + a.place * r[1 - a.along]);
    }
    const double b = (1.0 - r[0] * r[0]) * (1.0 - r[1] * r[1]);
    value[4] = b * r[0];
    value[5] = b * r[1];
    value[6] = b * r[0] * r[1];
    if constexpr (!centre) {
      value[7] = b;
    }
    return value;
  }
  /// Derivatives of the modes by the reference coordinates. [count, 2]
  static Eigen::Matrix<double, count, 2> dpsi(const shape::Point<2>& r) {
    Eigen::Matrix<double, count, 2> slope;
    for (int s = 0; s < sides; ++s) {
      const SideAxes& a = axes[static_cast<std::size_t>(s)];
      const double t = a.turn * r[a.along];
      slope(s, a.along) = -0.125 * a.turn * (1.0 - 3.0 * t * t) * (1.0 + a.place * r[1 - a.along]);
      slope(s, 1 - a.along) = -0.125 * t * (1.0 - t * t) * a.place;
    }
    const double x = r[0];
    const double y = r[1];
    const double bx = 1.0 - x * x;
    const double by = 1.0 - y * y;
    slope.row(4) << (1.0 - 3.0 * x * x) * by, -2.0 * x * y * bx;
    slope.row(5) << -2.0 * x * y * by, bx * (1.0 - 3.0 * y * y);
    slope.row(6) << y * (1.0 - 3.0 * x * x) * by, x * bx * (1.0 - 3.0 * y * y);
    if constexpr (!centre) {
      slope.row(7) << -2.0 * x * by, -2.0 * y * bx;
    }
    return slope;
  }
  /// Coordinate along side s, -1 at its first corner and 1 at its second.
  static double side_coordinate(const shape::Point<2>& r, int s) {
    const SideAxes& a = axes[static_cast<std::size_t>(s)];
    return a.turn * r[a.along];
  }
  /// Gradient of the side coordinate by the reference coordinates: a unit vector, with its sign.
  static Eigen::RowVector2d side_coordinate_gradient(int s) {
    const SideAxes& a = axes[static_cast<std::size_t>(s)];
    Eigen::RowVector2d d = Eigen::RowVector2d::Zero();
    d[a.along] = a.turn;
    return d;
  }
};

namespace detail {
template <class S> struct ModesOf;
template <> struct ModesOf<shape::Trimc6> : std::type_identity<TriangleModes> {};
template <> struct ModesOf<shape::Quamc8> : std::type_identity<QuadrilateralModes<false>> {};
template <> struct ModesOf<shape::Quamc9> : std::type_identity<QuadrilateralModes<true>> {};
} // namespace detail

/// The modes of a shape that has some.
template <shape::PlaneShape S> using Modes = typename detail::ModesOf<S>::type;

/// What a side's mode is at t in [-1, 1] from its first to its second corner.
inline double side_mode_value(double t) {
  return -0.25 * t * (1.0 - t * t);
}

/// Whether elements of a type have modes.
constexpr bool has_cubic_modes(base::ElementType type) {
  return type == base::ElementType::trimc6 || type == base::ElementType::quamc8 ||
         type == base::ElementType::quamc9;
}

/// Modes of an element at most.
inline constexpr int most_plane_modes = 8;

/// The modes of an element known when run, for what is not hot.
struct PlaneModes {
  using Values = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, most_plane_modes, 1>;
  using CoordinateGradients = Eigen::Matrix<double, Eigen::Dynamic, 2, 0, most_plane_modes, 2>;

  int sides = 0;
  int count = 0;
  int degree = 0; ///< of the rule of their stiffness
  Values (*psi)(const shape::Point<2>& r) = nullptr;
  CoordinateGradients (*dpsi)(const shape::Point<2>& r) = nullptr;
  double (*along)(const shape::Point<2>& r, int s) = nullptr;
  Eigen::RowVector2d (*d_along)(int s) = nullptr;

  /// Two of each mode.
  [[nodiscard]] int freedoms() const { return 2 * count; }

  /// Of a type that has some.
  static const PlaneModes& for_type(base::ElementType type);
};

/// Calls f(S{}) for a type that has modes.
template <class F> void with_mode_shape(base::ElementType type, F&& f) {
  switch (type) {
  case base::ElementType::trimc6:
    f(shape::Trimc6{});
    return;
  case base::ElementType::quamc8:
    f(shape::Quamc8{});
    return;
  case base::ElementType::quamc9:
    f(shape::Quamc9{});
    return;
  default:
    assert(false && "with_mode_shape: a type without modes");
  }
}

} // namespace spricka::estimate
