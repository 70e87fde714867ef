// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/diagnostics.hpp"
#include "mesh/gmsh_sizes.hpp"
#include "model/mesh.hpp"

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace spricka::mesh {

enum class ImportFormat { geo, msh };

struct ImportRequest {
  std::filesystem::path file;
  ImportFormat format = ImportFormat::geo;
  double scale = 1.0;     ///< every coordinate times this
  bool quadratic = false; ///< raise linear elements to quadratic ones
  std::string prefix;     ///< "LUG." or empty
  base::NetId net;
  std::vector<std::pair<std::string, std::string>> renames; ///< physical group -> set name
  std::vector<std::pair<std::string, double>> parameters;   ///< for DefineConstant of a .geo
  SizeWish size;           ///< for a .geo, in its own coordinates; empty: as the script has it
  base::Span span;         ///< the $IMPORT card
  bool skip_loads = false; ///< of an .inp: supports, loads and steps are passed over, not refused
};

/// Meshes a gmsh geometry script (.geo) or reads a .msh (2.2, 4.1) through the gmsh library and
/// appends mesh and sets: a physical group of the mesh's own dimension becomes an element set, one
/// dimension lower a face set, points and others a node set. Nodes of no element are dropped; node
/// order becomes ours (TET10 nodes 8 and 9 swapped). A deck parameter gives a DefineConstant of
/// the same name, upper or lower case. Second-order nodes lie on the geometry. Errors (missing
/// file, script errors with gmsh's own words, empty mesh) go to `diagnostics` at the card.
void import_mesh(model::Mesh& mesh, const ImportRequest& request, base::Diagnostics& diagnostics);

} // namespace spricka::mesh
