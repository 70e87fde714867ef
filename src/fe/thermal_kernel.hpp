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

} // namespace spricka::fe
