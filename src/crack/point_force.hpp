// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "crack/williams.hpp"

namespace spricka::crack {

/// Displacement gradient du_i/dx_j in global axes of a unit force per thickness, along the growth
/// direction, at the tip of a half-infinite crack (the auxiliary field of T: Kfouri 1986), at a
/// point off the tip: s_rr = - cos(theta) / (pi r) is its only stress (manual, crack.24, crack.25).
Eigen::Matrix2d point_force_gradient(const TipFrame& tip, const Polar& at,
                                     const model::ElasticMaterial& material,
                                     model::StressState state);

/// The displacement itself, global axes; lengths in units of `unit`, as a rigid motion is free.
base::Vec2 point_force_displacement(const TipFrame& tip, const Polar& at, double unit,
                                    const model::ElasticMaterial& material,
                                    model::StressState state);

} // namespace spricka::crack
