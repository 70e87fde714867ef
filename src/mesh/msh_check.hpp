// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <filesystem>
#include <string>

namespace spricka::mesh {

/// What is wrong with the frame of a gmsh mesh file, before the gmsh library reads it: not such a
/// file, a version other than 2.2 and 4.1, another byte order, sections that do not end. Empty for
/// a sound frame. Source: gmsh 4.8 reference manual, "MSH file format".
std::string msh_trouble(const std::filesystem::path& file);

} // namespace spricka::mesh
