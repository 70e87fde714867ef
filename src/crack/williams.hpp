// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/vec.hpp"
#include "model/forward.hpp"

namespace spricka::crack {

/// Where a plane crack tip stands and which way it looks: e1 along the growth direction, e2 to its
/// left; the crack lies on x1 < 0.
struct TipFrame {
  base::Vec2 x = base::Vec2::Zero();
  base::Vec2 e1 = base::Vec2::UnitX();
  base::Vec2 e2 = base::Vec2::UnitY();
};

/// A point seen from the tip, theta from e1 in -pi .. pi.
struct Polar {
  double r = 0.0, theta = 0.0;
};
/// Polar coordinates of a point about a tip: distance [length] and angle [rad] from e1.
Polar polar(const TipFrame& tip, const base::Vec2& at);
/// The same of a point of a face whose outer normal is n: round-off does not take a point of one
/// crack face to the other.
Polar polar_on_face(const TipFrame& tip, const base::Vec2& at, const base::Vec2& n);

/// Kolosov's constant: 3 - 4 nu in plane strain, (3 - nu)/(1 + nu) in plane stress.
double kolosov(double nu, model::StressState state);

/// Displacement gradient du_i/dx_j in global axes of the near-tip field with K = 1 in `mode` 1 or
/// 2 (Williams 1957), at a point off the tip.
Eigen::Matrix2d near_tip_gradient(const TipFrame& tip, const Polar& at, int mode,
                                  const model::ElasticMaterial& material, model::StressState state);

/// The same gradient at a point given by its coordinates.
inline Eigen::Matrix2d near_tip_gradient(const TipFrame& tip, const base::Vec2& at, int mode,
                                         const model::ElasticMaterial& material,
                                         model::StressState state) {
  return near_tip_gradient(tip, polar(tip, at), mode, material, state);
}

/// The displacement itself, global axes.
base::Vec2 near_tip_displacement(const TipFrame& tip, const Polar& at, int mode,
                                 const model::ElasticMaterial& material, model::StressState state);

/// The same near-tip displacement [length] for K = 1 at a point given by its coordinates.
inline base::Vec2 near_tip_displacement(const TipFrame& tip, const base::Vec2& at, int mode,
                                        const model::ElasticMaterial& material,
                                        model::StressState state) {
  return near_tip_displacement(tip, polar(tip, at), mode, material, state);
}

} // namespace spricka::crack
