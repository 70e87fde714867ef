// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/diagnostics.hpp"
#include "mesh/import/import_request.hpp"
#include "mesh/step_solids.hpp"

#include <optional>
#include <string>
#include <vector>

namespace spricka::mesh {

/// The solids of a STEP file, read by gmsh with OpenCASCADE in a process of its own [mm]. Each has
/// a name of its own that a deck can write: that of its part, or V1, V2 .. by its place in the
/// file. Empty after an error: a file that is no STEP file, is damaged or has no solid, or takes
/// too long.
std::optional<StepFileContents> describe_step_file(const ImportRequest& request,
                                                   base::Diagnostics& diagnostics);

/// How solids of a file are meshed unless more is said: the element set BODY and faces F1, F2 .. of
/// one solid; of several NAME and NAME_F1, NAME_F2 .. of each. Faces count in each solid.
StepMeshRequest make_step_mesh_request(const StepFileContents& contents, std::vector<int> solids);

/// The element size of a part whose deck says none [mm]: a fifteenth of the largest diagonal of a
/// box about one of its solids.
double usual_step_size(const StepFileContents& contents, const std::vector<int>& solids);

} // namespace spricka::mesh
