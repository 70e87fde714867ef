// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "model/mesh.hpp"

#include <string>

namespace spricka::mesh {

/// A mesh as the text of a gmsh file (format 4.1): element, face and node sets become physical
/// groups of their names, elements of no set the group REST when others have one. Coordinates have
/// as many digits as it takes to read the same bits back. Nodes of no element are left out; deck
/// numbers stay where they are unique. Source: gmsh 4.8 reference manual, "MSH file format".
std::string write_msh(const model::Mesh& mesh);

} // namespace spricka::mesh
