// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <string>
#include <string_view>

namespace spricka::mesh {

/// What is wrong with the frame of a gmsh mesh file, before the gmsh library reads it: not such a
/// file (what begins otherwise gmsh would run as a script), a version other than 2.2 and 4.1,
/// another byte order, sections that do not end. Empty for a sound frame. Source: gmsh 4.8
/// reference manual, "MSH file format".
std::string find_msh_format_error(std::string_view text);

} // namespace spricka::mesh
