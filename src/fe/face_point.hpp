// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "fe/face.hpp"

namespace spricka::fe {

/// The reference coordinates of a side, moved to the nearest point of its domain.
template <int dim>
shape::Point<dim> clamp_to_side(const AnyElement<dim>& side, const shape::Point<dim>& r);

/// Reference coordinates of the point of a side nearest to x: the foot of the perpendicular, or the
/// nearest point of its edges. Compiled in face_point.cpp for lines and for sides of solids.
template <int dim>
shape::Point<dim> nearest_on_side(const AnyElement<dim>& side, const SpaceNodes<dim>& X,
                                  const base::Vec3& x);

} // namespace spricka::fe
