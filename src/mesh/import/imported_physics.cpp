// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/import/imported_physics.hpp"

#include "model/model.hpp"

namespace spricka::mesh {

void append_materials_and_equations(model::Model& model,
                                    const ImportedMaterialsAndEquations& physics) {
  const std::size_t first = model.materials.size();
  model.materials.insert(model.materials.end(), physics.materials.begin(), physics.materials.end());
  for (model::ElementProperty property : physics.properties) {
    property.material = base::MaterialId(first + property.material.index());
    for (const base::ElementId e : model.mesh.set_with_id(property.elements).elements) {
      model.mesh.property[e.index()] = base::PropertyId(model.properties.size());
    }
    model.properties.push_back(property);
  }
  model.mpcs.insert(model.mpcs.end(), physics.equations.begin(), physics.equations.end());
}

} // namespace spricka::mesh
