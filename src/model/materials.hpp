// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/id.hpp"
#include "base/source.hpp"

#include <string>

/// Materials and the elements that are made of them.
namespace spricka::model {

/// Isotropic, linear elastic.
struct ElasticMaterial {
  std::string name;
  double E = 0.0;     ///< Young's modulus [stress]
  double nu = 0.0;    ///< Poisson's ratio
  double rho = 0.0;   ///< density
  double alpha = 0.0; ///< thermal expansion [1/K]
  base::SourceSpan span;
};

enum class StressState { plane_stress, plane_strain, axisymmetric, solid };

/// The dimension of the elements that are in a state.
constexpr int element_dimension(StressState state) {
  return state == StressState::solid ? 3 : 2;
}

/// Whether the elements in a state have a thickness: those of the plane that turn about no axis.
constexpr bool has_thickness(StressState state) {
  return state == StressState::plane_stress || state == StressState::plane_strain;
}

struct ElementProperty {
  base::ElementSetId elements;
  base::MaterialId material;
  StressState state = StressState::plane_stress;
  double thickness = 1.0; ///< [length]
  base::SourceSpan span;
};

/// Whether elements hardly change their volume, so that plain displacement elements lock: at
/// nu = 0.49 quadratic ones are still right to some 0.02 %, linear ones 6 % stiff (thick cylinder
/// of MacNeal and Harder, 12 elements through the wall).
inline bool is_nearly_incompressible(const ElasticMaterial& material, StressState state,
                                     bool quadratic) {
  return state != StressState::plane_stress && material.nu > (quadratic ? 0.49 : 0.4);
}

} // namespace spricka::model
