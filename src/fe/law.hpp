// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "fe/elasticity.hpp"

#include <numbers>

namespace spricka::fe {

/// Everything that an element's kernels need of its material and property, as plain numbers.
/// Axisymmetric bodies have x as radius, y as axis and are whole: a ring of 2 pi x stands behind
/// each point, and loads and reactions count the full circumference.
struct Law {
  double lambda = 0.0;       ///< Lame's constants [stress]; in plane stress the reduced lambda
  double mu = 0.0;           ///< shear modulus [stress]
  double thickness = 1.0;    ///< [length]; 1 in space
  double thermal = 0.0;      ///< stress that a temperature of 1 takes out: sigma -= thermal * T
  bool plane_stress = false; ///< sigma_zz is zero
  bool axisymmetric = false;
  /// The dilatation is projected (see dilatation.hpp): displacement elements lock where a material
  /// hardly changes its volume.
  bool projected = false;

  /// What stands behind a point of the mesh plane: thickness, circumference, or 1 in space.
  [[nodiscard]] double depth(double x) const {
    return axisymmetric ? 2.0 * std::numbers::pi * x : thickness;
  }
};

/// Poisson's ratio from which on the dilatation is projected. At 0.49 plain quadratic elements are
/// still right to some 0.1 %, and the projected ones as well.
inline constexpr double nearly_incompressible = 0.49;

/// Law of a property's elements.
Law law_of(const model::Material& material, const model::Property& property);

/// Law of the elements of `e`'s property.
inline Law law_of(const model::Model& model, const model::Mesh& mesh, base::ElementId e) {
  return law_of(model.material_of(mesh, e), model.property_of(mesh, e));
}

} // namespace spricka::fe
