// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "mesh/import/gmsh_import.hpp"
#include "model/model.hpp"

#include <string>
#include <vector>

namespace spricka::mesh {

/// What an Abaqus or CalculiX input file says besides its mesh.
struct ImportedPhysics {
  std::vector<model::Material> materials;  ///< named as sets are, "NET.STEEL"
  std::vector<model::Property> properties; ///< from *SOLID SECTION; material counts from 0 here
  std::vector<model::Equation> equations;  ///< tied freedoms
  std::vector<std::string> files;          ///< paths of the file and of those it includes
};

/// Reads the model part of an Abaqus or CalculiX input file and appends its mesh and sets (*NSET,
/// *ELSET, *SURFACE). Nodes of no element are dropped. A keyword that is not understood and could
/// change the physics is an error at the card, with its place in the file; all are told at once.
/// SCALE holds for coordinates and thicknesses. Element types with reduced integration or other
/// special forms are taken with a warning. After an error the mesh is unchanged. See
/// manual/meshes.md.
ImportedPhysics import_inp(model::Mesh& mesh, const ImportRequest& request,
                           base::Diagnostics& diagnostics);

/// Puts imported materials, properties and equations behind those of a model and gives the elements
/// their properties.
void append_physics(model::Model& model, const ImportedPhysics& physics);

} // namespace spricka::mesh
