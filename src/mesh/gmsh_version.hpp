// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <string>

namespace spricka::mesh {

/// The version of the gmsh library that the program is running with, "4.8.4".
std::string gmsh_version();

} // namespace spricka::mesh
