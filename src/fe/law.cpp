// SPDX-License-Identifier: GPL-3.0-or-later
#include "fe/law.hpp"

#include "model/model.hpp"

namespace spricka::fe {

Law law_of(const model::Material& material, const model::Property& property,
           base::ElementType type) {
  const Lame k = lame(material, property.state);
  Law law;
  law.lambda = k.lambda;
  law.mu = k.mu;
  law.plane_stress = property.state == model::State::plane_stress;
  law.axisymmetric = property.state == model::State::axisymmetric;
  const bool plane = law.plane_stress || property.state == model::State::plane_strain;
  law.thickness = plane ? property.thickness : 1.0;
  law.expansion = material.alpha;
  law.projected =
      model::nearly_incompressible(material, property.state, base::info(type).quadratic);
  return law;
}

Law law_of(const model::Model& model, const model::Mesh& mesh, base::ElementId e) {
  return law_of(model.material_of(mesh, e), model.property_of(mesh, e), mesh.type[e.index()]);
}

} // namespace spricka::fe
