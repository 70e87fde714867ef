// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "fe/element.hpp"
#include "model/mesh.hpp"

#include <functional>
#include <type_traits>

/// What a temperature does to one element. Bodies are compiled in thermal_kernel.cpp for each
/// element.
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

/// A temperature that is linear in x in a plane element, and the displacement it drives where
/// nothing holds the element, which strains it the same in all directions. Quadratic elements that
/// do not hold quadratic functions cannot follow it: in them it is taken out beforehand and the
/// nodes bear the rest, which leaves no stress of a linear temperature in any element.
template <shape::ElementShape S> class FreeExpansion {
public:
  FreeExpansion() = default; ///< of nothing
  /// Of corner values that lie on a plane, or of the plane nearest to them.
  FreeExpansion(const NodeVectors<S>& X, const Law& law, const CornerValues<S>& T);
  /// Whether an element has to take it out beforehand.
  [[nodiscard]] static bool wanted(const NodeVectors<S>& X, const Law& law);
  [[nodiscard]] double temperature(const base::Vec2& x) const {
    return plane_[0] + plane_.template tail<2>().dot(x - centre_);
  }
  [[nodiscard]] base::Vec2 slope() const { return plane_.template tail<2>(); }
  [[nodiscard]] base::Vec2 displacement(const base::Vec2& x) const;
  [[nodiscard]] Eigen::Matrix2d gradient(const base::Vec2& x) const;
  [[nodiscard]] NodeVectors<S> at_nodes(const NodeVectors<S>& X) const;

private:
  base::Vec2 centre_ = base::Vec2::Zero();
  double strain_ = 0.0; ///< of a temperature of 1
  Eigen::Vector3d plane_ = Eigen::Vector3d::Zero();
};

/// Functions of the corner temperatures of an element: those of its linear relative, in quadratic
/// solids with what makes a temperature that is linear in x that in the element too, wherever the
/// nodes of its edges are (manual, fe.40).
template <shape::ElementShape S> class HeatFunctions {
public:
  explicit HeatFunctions(const NodeVectors<S>& X);
  [[nodiscard]] CornerValues<S> at(const shape::Point<S::dim>& r) const;
  /// Their gradients by x. [corners, dim]
  [[nodiscard]] Eigen::Matrix<double, corners<S>(), S::dim>
  gradients(const Jacobian<S>& at, const shape::Point<S::dim>& r) const;

private:
  static constexpr bool bent = S::dim == 3 && base::info(S::type).quadratic;

  NodeVectors<S> X_;
  Eigen::Matrix<double, corners<S>(), S::dim> slope_; ///< of a plane through corner values
};

/// What a temperature T takes out of the normal stresses of an element: a body held all round
/// carries -alpha (3 lambda T + 2 mu T); in plane stress, with the reduced lambda, two directions
/// are held. Where the volume change is projected, so is the temperature that drives it: a body
/// free to expand would keep stresses else.
template <shape::ElementShape S> struct ThermalStress {
  const Law& law;
  CornerValues<S> T;
  HeatFunctions<S> functions;
  typename Dilatation<S>::Modes projected = Dilatation<S>::Modes::Zero();

  ThermalStress(const NodeVectors<S>& X, const Law& law_, const CornerValues<S>& T_);
  [[nodiscard]] double temperature(const shape::Point<S::dim>& r) const {
    return T.dot(functions.at(r));
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

/// A temperature field(x) as an element takes it: constant in linear elements, linear in the
/// reference coordinates of quadratic ones, and in x where plane ones do not hold quadratic
/// functions, in solids by HeatFunctions; the nearest to the field at the points of a rule.
/// Compiled in thermal_kernel_project.cpp.
template <shape::ElementShape S>
using Temperature = std::function<double(const Eigen::Matrix<double, S::dim, 1>& x)>;
template <shape::ElementShape S>
CornerValues<S> project_temperature(const NodeVectors<S>& X, const Law& law,
                                    std::span<const shape::QuadraturePoint<S::dim>> rule,
                                    const Temperature<S>& field);

/// Consistent forces of an element's temperatures.
template <shape::ElementShape S>
NodeVectors<S> thermal_forces(const NodeVectors<S>& X, const Law& law, const CornerValues<S>& T);

} // namespace spricka::fe
