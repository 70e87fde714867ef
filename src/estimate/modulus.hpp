// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "fe/stress.hpp"
#include "model/model.hpp"

namespace spricka::estimate {

/// What a stiffer material amounts to as loads, E d/dE (f - K u) with the thermal loads in f
/// (manual, sensitivity.8). [dim * node, material]
base::Matrix modulus_loads(const model::Model& model, const model::Mesh& mesh,
                           const fe::StateField& state);

} // namespace spricka::estimate
