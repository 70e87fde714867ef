// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "fe/locate.hpp"
#include "fe/stress.hpp"

namespace spricka::fe {

/// Stress on one side of a point: the mean of its elements there in the material of the nearest.
/// The side is not empty.
Stress side_stress(const model::Model& model, const model::Mesh& mesh, const StateField& field,
                   const PointSide& side);

} // namespace spricka::fe
