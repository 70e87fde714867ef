// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "mesh/link/gmsh_model.hpp"
#include "mesh/link/grading.hpp"
#include "mesh/link/mesher_request.hpp"
#include "mesh/link/region.hpp"
#include "mesh/step_solids.hpp"

#include <functional>

namespace spricka::mesher {

/// Fills a region by gmsh's Delaunay mesher; `trouble` has its words where it fails.
mesh::TriangleFill fill_region_by_gmsh(const mesh::PlaneRegion& region, const mesh::Grading& size);

/// Fills a region of space by gmsh's Delaunay mesher; `trouble` has its words where it fails.
mesh::TetrahedronFill fill_region_by_gmsh(const mesh::SolidRegion& region,
                                          const mesh::SolidGrading& size);

/// Opens the file that `path` names, meshes it if it is a script without a mesh or a STEP file, and
/// takes out all that is wanted. `meshing` is called when the file is read. Errors and warnings are
/// in the model.
mesh::GmshModel read_gmsh_model(const mesh::MesherImportRequest& import, const std::string& path,
                                const std::function<void()>& meshing);

/// The solids and faces of the STEP file that `path` names. Errors and warnings are with them.
mesh::StepFileContents describe_step_file(const std::string& path);

/// Prepares the STEP file that gmsh has opened for meshing: solids that are not wanted go, groups
/// are made, sizes are set. False where the request names what is not there.
bool prepare_step_mesh(const mesh::StepMeshRequest& request);

} // namespace spricka::mesher
