// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "fe/locate.hpp"
#include "fe/stress.hpp"

namespace spricka::fe {

/// Stress on one side of a point: the mean of its elements there in the material of the nearest.
/// The side is not empty.
Stress stress_of_element_group(const model::Model& model, const model::Mesh& mesh,
                               const DisplacementTemperatureField& field,
                               const PointElementGroup& side);

} // namespace spricka::fe
