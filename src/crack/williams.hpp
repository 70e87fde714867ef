// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/vec.hpp"
#include "model/model.hpp"

namespace spricka::crack {

/// Where a plane crack tip stands and which way it looks: e1 along the growth direction, e2 to its
/// left; the crack lies on x1 < 0.
struct TipFrame {
  base::Vec2 x = base::Vec2::Zero();
  base::Vec2 e1 = base::Vec2::UnitX();
  base::Vec2 e2 = base::Vec2::UnitY();
};

/// Kolosov's constant: 3 - 4 nu in plane strain, (3 - nu)/(1 + nu) in plane stress.
double kolosov(double nu, model::State state);

/// Displacement gradient du_i/dx_j in global axes of the near-tip field with K = 1 in `mode` 1 or
/// 2 (Williams 1957), at a point off the tip.
Eigen::Matrix2d auxiliary_gradient(const TipFrame& tip, const base::Vec2& at, int mode,
                                   const model::Material& material, model::State state);

/// The displacement itself, global axes.
base::Vec2 auxiliary_displacement(const TipFrame& tip, const base::Vec2& at, int mode,
                                  const model::Material& material, model::State state);

} // namespace spricka::crack
