// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "deck/imported_script.hpp"
#include "mesh/step_solids.hpp"

#include <memory>
#include <string>
#include <vector>

namespace spricka::deck {

/// A STEP file that a deck has imported: all its solids, and what was meshed of them.
struct ImportedStepFile {
  std::string file;
  std::string net;
  std::shared_ptr<const mesh::StepFileContents> contents;
  mesh::StepMeshRequest request;
  double scale = 1.0; ///< a millimetre of the file in lengths of the deck
};

/// What is known of the geometries that a deck imports, in its order.
struct ImportedGeometry {
  std::vector<ImportedScript> scripts;
  std::vector<ImportedStepFile> step_files;
  std::string length_name; ///< the deck's unit of length
};

} // namespace spricka::deck
