// SPDX-License-Identifier: GPL-3.0-or-later
#include "fe/law.hpp"

#include "model/model.hpp"

namespace spricka::fe {

Law law_of(const model::ElasticMaterial& material, const model::ElementProperty& property,
           base::ElementType type) {
  const Lame k = lame(material, property.state);
  Law law;
  law.lambda = k.lambda;
  law.mu = k.mu;
  law.plane_stress = property.state == model::StressState::plane_stress;
  law.axisymmetric = property.state == model::StressState::axisymmetric;
  const bool plane = law.plane_stress || property.state == model::StressState::plane_strain;
  law.thickness = plane ? property.thickness : 1.0;
  law.expansion = material.alpha;
  law.projected =
      model::nearly_incompressible(material, property.state, base::element_info(type).quadratic);
  return law;
}

Law law_of(const model::Model& model, const model::Mesh& mesh, base::ElementId e) {
  return law_of(model.element_material(mesh, e), model.element_property(mesh, e),
                mesh.type[e.index()]);
}

} // namespace spricka::fe
