// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "mesh/link/gmsh_model.hpp"
#include "mesh/link/grading.hpp"
#include "mesh/link/mesher_request.hpp"
#include "mesh/link/region.hpp"

#include <functional>

namespace spricka::mesher {

/// Fills a region by gmsh's Delaunay mesher; `trouble` has its words where it fails.
mesh::TriangleFill fill_region_by_gmsh(const mesh::PlaneRegion& region, const mesh::Grading& size);

/// Fills a region of space by gmsh's Delaunay mesher; `trouble` has its words where it fails.
mesh::TetrahedronFill fill_region_by_gmsh(const mesh::SolidRegion& region,
                                          const mesh::SolidGrading& size);

/// Opens the file that `path` names, meshes it if it is a script without a mesh, and takes out all
/// that is wanted. `meshing` is called when the script is read. Errors and warnings are in the
/// model.
mesh::GmshModel read_gmsh_model(const mesh::MesherImportRequest& import, const std::string& path,
                                const std::function<void()>& meshing);

} // namespace spricka::mesher
