// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/diagnostics.hpp"
#include "mesh/import/import_request.hpp"
#include "mesh/import/script_scan.hpp"
#include "mesh/link/gmsh_model.hpp"

#include <optional>
#include <vector>

namespace spricka::mesh {

struct GmshReadResult {
  std::optional<GmshModel> model; ///< empty after an error
  std::vector<GeometryScriptConstant> constants;
};

/// What gmsh, in its own process, makes of a script or mesh file. The file is looked through first:
/// a script for what reaches outside, a mesh for its frame. Mistakes are reported at the card.
GmshReadResult read_by_gmsh(const ImportRequest& request, base::Diagnostics& diagnostics);

} // namespace spricka::mesh
