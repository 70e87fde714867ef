// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/diagnostics.hpp"
#include "mesh/import/import_request.hpp"
#include "mesh/import/imported_physics.hpp"
#include "mesh/import/inp_data.hpp"
#include "model/mesh.hpp"

#include <vector>

namespace spricka::mesh {

/// Reads the model part of an Abaqus or CalculiX input file and appends its mesh and sets (*NSET,
/// *ELSET, *SURFACE). Nodes of no element are dropped. A keyword that is not understood and could
/// change the physics is an error at the card, with its place in the file; all are told at once.
/// SCALE holds for coordinates and thicknesses. Element types with reduced integration or other
/// special forms are taken with a warning. After an error the mesh is unchanged. See
/// manual/meshes.md.
ImportedMaterialsAndEquations import_inp(model::Mesh& mesh, const ImportRequest& request,
                                         base::Diagnostics& diagnostics);

/// Appends what a file says that has been read already, as import_inp does; `complaints` of the
/// reading are reported, and nothing is appended then.
ImportedMaterialsAndEquations import_inp_data(model::Mesh& mesh, const ImportRequest& request,
                                              InpData data, std::vector<InpIssue> complaints,
                                              base::Diagnostics& diagnostics);

} // namespace spricka::mesh
