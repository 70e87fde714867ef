// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/diagnostics.hpp"
#include "mesh/import/import_request.hpp"
#include "mesh/import/imported_physics.hpp"
#include "model/mesh.hpp"

namespace spricka::mesh {

/// Reads Nastran bulk data and appends their mesh: solids, or shells of the plane z = 0, with sets
/// by property, surfaces, materials MAT1 and properties. An entry that is not read and could change
/// the physics is an error at the card, each kind once with its number; all are told at once.
/// Supports and loads are among these unless they are to be passed over; where they act is kept in
/// sets. SCALE holds for coordinates and thicknesses. After an error the mesh is unchanged. See
/// manual/meshes.md.
ImportedMaterialsAndEquations import_nastran(model::Mesh& mesh, const ImportRequest& request,
                                             base::Diagnostics& diagnostics);

} // namespace spricka::mesh
