// SPDX-License-Identifier: GPL-3.0-or-later
#include "fe/law.hpp"

#include "model/model.hpp"

namespace spricka::fe {

ConstitutiveLaw constitutive_law(const model::ElasticMaterial& material,
                                 const model::ElementProperty& property, base::ElementType type) {
  const LameConstants k = lame_constants(material, property.state);
  ConstitutiveLaw law;
  law.lambda = k.lambda;
  law.mu = k.mu;
  law.plane_stress = property.state == model::StressState::plane_stress;
  law.axisymmetric = property.state == model::StressState::axisymmetric;
  law.thickness = model::has_thickness(property.state) ? property.thickness : 1.0;
  law.expansion = material.alpha;
  law.projected =
      model::is_nearly_incompressible(material, property.state, base::element_info(type).quadratic);
  return law;
}

ConstitutiveLaw constitutive_law(const model::Model& model, const model::Mesh& mesh,
                                 base::ElementId e) {
  return constitutive_law(model.element_material(mesh, e), model.element_property(mesh, e),
                          mesh.type[e.index()]);
}

} // namespace spricka::fe
