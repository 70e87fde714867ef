// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/diagnostics.hpp"
#include "mesh/import/import_request.hpp"
#include "mesh/import/script_scan.hpp"

#include <string>
#include <vector>

namespace spricka::mesh {

/// A geometry script made ready for gmsh.
struct PreparedScript {
  /// With the deck's parameters set in its first line, blanks for what is passed over.
  std::string text;
  std::vector<GeometryScriptConstant> constants;
};

/// Sets the parameters of a request in the names of the script's constants, whatever the case of
/// letters, and in upper and lower case for scripts that use a name they do not define. (gmsh's
/// DefineConstant leaves a name alone that has a value.) Constants that differ by case only take
/// the parameter that is written like them; without such a one they are an error.
PreparedScript prepare_script_with_parameters(const std::string& text, const ScriptScan& scan,
                                              const ImportRequest& request,
                                              base::Diagnostics& diagnostics);

} // namespace spricka::mesh
