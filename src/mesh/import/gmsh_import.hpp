// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/diagnostics.hpp"
#include "mesh/size_wish.hpp"
#include "model/mesh.hpp"

#include <filesystem>
#include <optional>
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
  SizeWish size = {};      ///< for a .geo, in its own coordinates; empty: as the script has it
  base::Span span;         ///< the $IMPORT card
  bool skip_loads = false; ///< of an .inp: supports, loads and steps are passed over, not refused
};

/// A number to which a geometry script gives a name.
struct ScriptConstant {
  std::string name;       ///< as the script writes it
  bool defined = true;    ///< by DefineConstant; else the script sets it, whatever the deck says
  bool from_deck = false; ///< a parameter of the deck has set it
  std::optional<double> value; ///< at the end of the script; empty if it is no number or has none
  std::string text;            ///< its default, as the script writes it
};

/// Meshes a gmsh geometry script (.geo) or reads a .msh (2.2, 4.1) through the gmsh library, in a
/// process of its own that reaches nothing else (mesher_link.hpp), and appends mesh and sets: a
/// physical group of the mesh's own dimension becomes an element set, one dimension lower a face
/// set, points and others a node set. Nodes of no element are dropped; node order becomes ours
/// (TET10 nodes 8 and 9 swapped). A deck parameter gives a DefineConstant of the same name its
/// value, whatever the case of letters. Second-order nodes lie on the geometry. Errors (missing
/// file, statements that reach outside of the script, script errors with gmsh's own words, crashes,
/// limits of time and memory, empty mesh) go to `diagnostics` at the card. Returns the constants of
/// a script in its order, and the names it sets itself that are those of parameters.
std::vector<ScriptConstant> import_mesh(model::Mesh& mesh, const ImportRequest& request,
                                        base::Diagnostics& diagnostics);

} // namespace spricka::mesh
