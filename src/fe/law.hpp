// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/element_type.hpp"
#include "base/id.hpp"
#include "fe/elasticity.hpp"
#include "model/forward.hpp"

#include <numbers>

namespace spricka::fe {

/// Everything that an element's kernels need of its material and property, as plain numbers.
/// Axisymmetric bodies have x as radius, y as axis and are whole: a ring of 2 pi x stands behind
/// each point, and loads and reactions count the full circumference.
struct ConstitutiveLaw {
  double lambda = 0.0;       ///< Lame's constants [stress]; in plane stress the reduced lambda
  double mu = 0.0;           ///< shear modulus [stress]
  double thickness = 1.0;    ///< [length]; 1 in space
  double expansion = 0.0;    ///< thermal, of a temperature of 1
  bool plane_stress = false; ///< sigma_zz is zero
  bool axisymmetric = false;
  /// The dilatation is projected (see dilatation.hpp): displacement elements lock where a material
  /// hardly changes its volume.
  bool projected = false;

  /// Whether elements of a dimension turn about the axis: solids never do, and code for them that
  /// is compiled for each dimension leaves out what hoop strains bring.
  template <int dim> [[nodiscard]] bool is_axisymmetric() const { return dim == 2 && axisymmetric; }

  /// Strains that a temperature drives and that the state holds: two in plane stress.
  [[nodiscard]] double heated_direction_count() const { return plane_stress ? 2.0 : 3.0; }

  /// What stands behind a point of the mesh plane: thickness, circumference, or 1 in space.
  [[nodiscard]] double depth(double x) const {
    return axisymmetric ? 2.0 * std::numbers::pi * x : thickness;
  }
};

/// Law of a property's elements of one type.
ConstitutiveLaw constitutive_law(const model::ElasticMaterial& material,
                                 const model::ElementProperty& property, base::ElementType type);

/// Law of the element `e` by its property, its material and its type.
ConstitutiveLaw constitutive_law(const model::Model& model, const model::Mesh& mesh,
                                 base::ElementId e);

} // namespace spricka::fe
