// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/diagnostics.hpp"
#include "mesh/import/import_request.hpp"
#include "mesh/import/script_scan.hpp"
#include "model/mesh.hpp"

#include <vector>

namespace spricka::mesh {

/// Meshes a gmsh geometry script (.geo) or reads a .msh (2.2, 4.1) through the gmsh library, in a
/// process of its own that reaches nothing else (mesher_link.hpp), and appends mesh and sets: a
/// physical group of the mesh's own dimension becomes an element set, one dimension lower a face
/// set, points and others a node set. Nodes of no element are dropped; node order becomes ours
/// (TET10 nodes 8 and 9 swapped). A deck parameter gives a DefineConstant of the same name its
/// value, whatever the case of letters. Second-order nodes lie on the geometry. Errors (missing
/// file, statements that reach outside of the script, script errors with gmsh's own words, crashes,
/// limits of time and memory, empty mesh) go to `diagnostics` at the card. Returns the constants of
/// a script in its order, and the names it sets itself that are those of parameters.
std::vector<GeometryScriptConstant> import_gmsh_mesh_or_script(model::Mesh& mesh,
                                                               const ImportRequest& request,
                                                               base::Diagnostics& diagnostics);

} // namespace spricka::mesh
