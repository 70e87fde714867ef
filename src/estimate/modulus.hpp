// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/vec.hpp"
#include "model/forward.hpp"

namespace spricka::estimate {

/// Thermal loads by material [dim * node, material] of a temperature field [connectivity index].
/// With K u they make what a stiffer material amounts to as loads, E d/dE (f - K u) (manual,
/// sensitivity.8).
base::Matrix thermal_loads(const model::Model& model, const model::Mesh& mesh,
                           const base::Vector& temperature);

} // namespace spricka::estimate
