// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "crack/williams.hpp"

namespace spricka::test {

/// Displacement gradient of K = 1 in `mode` 1 or 2 at a point given by its coordinates.
inline Eigen::Matrix2d near_tip_gradient(const crack::TipFrame& tip, const base::Vec2& at, int mode,
                                         const model::ElasticMaterial& material,
                                         model::StressState state) {
  return crack::near_tip_gradient(tip, crack::polar_coordinates(tip, at),
                                  static_cast<std::size_t>(mode),
                                  crack::make_section_body(material, state));
}

/// The near-tip displacement [length] for K = 1 at a point given by its coordinates.
inline base::Vec2 near_tip_displacement(const crack::TipFrame& tip, const base::Vec2& at, int mode,
                                        const model::ElasticMaterial& material,
                                        model::StressState state) {
  return crack::near_tip_displacement(tip, crack::polar_coordinates(tip, at),
                                      static_cast<std::size_t>(mode),
                                      crack::make_section_body(material, state));
}

} // namespace spricka::test
