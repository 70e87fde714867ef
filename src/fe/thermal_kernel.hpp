// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "fe/element.hpp"

namespace spricka::fe {

/// Values at the corners of an element; between them its linear relative S::Corner interpolates.
template <shape::ElementShape S> using CornerValues = Eigen::Matrix<double, S::corners, 1>;

/// Corner temperatures of an element out of a field by connectivity index; zero where the field is
/// empty.
template <shape::ElementShape S>
CornerValues<S> corner_temperature(const model::Mesh& mesh, base::ElementId e,
                                   const base::Vector& temperature) {
  if (temperature.size() == 0) {
    return CornerValues<S>::Zero();
  }
  return temperature.template segment<S::corners>(mesh.first[e.index()]);
}

} // namespace spricka::fe
