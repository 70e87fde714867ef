// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "fe/element.hpp"

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

} // namespace spricka::fe
