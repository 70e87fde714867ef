// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/id.hpp"
#include "base/source.hpp"
#include "mesh/script_size_request.hpp"
#include "mesh/step_solids.hpp"

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace spricka::mesh {

enum class ImportFormat { geo, msh, step };

/// What of an .inp is passed over and listed, not refused: nothing; supports, loads and steps; all
/// but mesh, sets, surfaces and what is elastic.
enum class InpSkip { nothing, loads, all };

/// A mesh file or geometry script of another program, and how it is taken over.
struct ImportRequest {
  std::filesystem::path file;
  ImportFormat format = ImportFormat::geo;
  double scale = 1.0;     ///< every coordinate times this
  bool quadratic = false; ///< raise linear elements to quadratic ones
  std::string prefix;     ///< "LUG." or empty
  base::NetId net;
  std::vector<std::pair<std::string, std::string>> renames; ///< physical group -> set name
  std::vector<std::pair<std::string, double>> parameters;   ///< for DefineConstant of a .geo
  ScriptSizeMap size = {};   ///< for a .geo, in its own coordinates; empty: as the script has it
  StepMeshRequest step = {}; ///< of a STEP file
  base::SourceSpan span;     ///< the $IMPORT card
  InpSkip skip = InpSkip::nothing; ///< of an .inp and of bulk data
  std::string element_set;         ///< of an .inp: its elements alone are taken; empty: all
  /// Of an .inp with SKIP=ALL: somebody makes cards of contact, ties, supports and loads, so that
  /// these are not listed.
  bool joint_taken = false;
  bool contact_elsewhere = false; ///< of an .inp: the deck says contact and ties
  bool reported = false;          ///< of an .inp: it was read before, its warnings are given
};

} // namespace spricka::mesh
