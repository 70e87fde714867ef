// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "mesh/link/bytes.hpp"
#include "mesh/link/gmsh_model.hpp"
#include "mesh/link/grading.hpp"
#include "mesh/link/region.hpp"
#include "mesh/script_size_request.hpp"
#include "mesh/step_solids.hpp"

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace spricka::mesh {

// What spricka and spricka-mesher say to each other, each a frame of bytes: its length (8 bytes),
// then its kind (1 byte), then what the kind has.

enum class MesherFrameKind : char {
  fill = 'f',          ///< to the mesher: a region and its sizes
  fill_solid = 'v',    ///< to the mesher: a region of space and its sizes
  import = 'i',        ///< to the mesher: a script or mesh file
  describe = 'd',      ///< to the mesher: a STEP file, of which the solids are asked for
  meshing = 'm',       ///< from the mesher: the script is read, its mesh begins
  filling = 'F',       ///< answer
  solid_filling = 'V', ///< answer
  model = 'M',         ///< answer
  solids = 'S',        ///< answer
  no_memory = 'o',     ///< answer, and its last one
  no_sandbox = 's',    ///< answer: the kernel has no way to lock the mesher in
  bad_request = 'b',   ///< answer
};

/// A geometry script, mesh or STEP file, by its text.
struct MesherImportRequest {
  /// For gmsh's messages: letters, digits, "._-"; ends with .geo, .msh or .step.
  std::string name;
  std::string text;
  bool script = false;
  bool quadratic = false;
  ScriptSizeMap size;                  ///< of a script
  std::vector<std::string> constants;  ///< of a script, whose values at its end are asked for
  std::optional<StepMeshRequest> step; ///< of a STEP file
};

/// The request that asks the mesher process to fill a region of the plane or of space, as bytes.
template <int dim>
std::string encode_fill_request(const FillRegion<dim>& region, const SizeGrading<dim>& size);

/// Reads such a request behind its kind. False if the bytes are none or name points that are not
/// there.
template <int dim>
bool decode_fill_request(ByteReader& in, FillRegion<dim>& region, SizeGrading<dim>& size);

/// The answer of the mesher process to such a request, as bytes.
template <int dim> std::string encode_fill_answer(const MeshFill<dim>& filling);

/// Reads the answer to a request for `region`. False if the bytes are none, name points that are
/// not there, or give places that are not finite.
template <int dim>
bool decode_fill_answer(ByteReader& in, const FillRegion<dim>& region, MeshFill<dim>& filling);

/// The request that asks the mesher process to read a script or mesh file, as bytes.
std::string encode_import_request(const MesherImportRequest& import);
/// Reads such a request. False if the bytes are none.
bool decode_import_request(ByteReader& in, MesherImportRequest& import);

/// The answer to such a request, as bytes: nodes, elements, groups, constants and messages.
std::string encode_model_answer(const GmshModel& model);
/// Checks that all lists belong together, so that nothing need be looked at twice.
bool decode_model_answer(ByteReader& in, GmshModel& model);

/// A STEP file by its name for gmsh's messages and its text.
struct StepFileText {
  std::string name;
  std::string text;
};

/// The request that asks the mesher process what solids a STEP file holds, as bytes.
std::string encode_describe_request(const StepFileText& file);
/// Reads such a request. False if the bytes are none.
bool decode_describe_request(ByteReader& in, StepFileText& file);

/// The answer to such a request, as bytes.
std::string encode_solids_answer(const StepFileContents& contents);
/// False if the bytes are none, or give numbers that are not finite.
bool decode_solids_answer(ByteReader& in, StepFileContents& contents);

} // namespace spricka::mesh
