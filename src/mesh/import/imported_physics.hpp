// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/import/inp_joint.hpp"
#include "model/forward.hpp"
#include "model/freedoms.hpp"
#include "model/materials.hpp"

#include <string>
#include <vector>

namespace spricka::mesh {

/// What an Abaqus or CalculiX input file says besides its mesh.
struct ImportedMaterialsAndEquations {
  std::vector<model::ElasticMaterial> materials; ///< named as sets are, "NET.STEEL"
  std::vector<model::ElementProperty>
      properties; ///< from *SOLID SECTION; material counts from 0 here
  std::vector<model::ConstraintEquation> equations; ///< tied freedoms
  std::vector<std::string> files;                   ///< paths of the file and of those it includes
  InpJointCards joint;                              ///< of an .inp with SKIP=ALL
};

/// Puts imported materials, properties and equations behind those of a model and gives the elements
/// their properties.
void append_materials_and_equations(model::Model& model,
                                    const ImportedMaterialsAndEquations& physics);

} // namespace spricka::mesh
