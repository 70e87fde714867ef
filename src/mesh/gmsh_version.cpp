// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/gmsh_version.hpp"

#include "mesh/gmsh_session.hpp"

#include <gmsh.h>

namespace spricka::mesh {

std::string gmsh_version() {
  const GmshSession session;
  std::string version;
  gmsh::option::getString("General.Version", version);
  return version;
}

} // namespace spricka::mesh
