// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <string>
#include <string_view>
#include <vector>

namespace spricka::mesh {

/// Whether a text begins as a STEP file (ISO 10303-21) does.
bool is_step_text(std::string_view text);

/// What is wrong with the frame of a STEP file before the gmsh library reads it: another kind of
/// file (an IGES file is named), sections that do not end, a schema of buildings. Empty for a sound
/// frame. Source: ISO 10303-21, the exchange structure.
std::string find_step_format_error(std::string_view text);

/// Files that a STEP file names instead of holding their parts, each once.
std::vector<std::string> files_named_by_step(std::string_view text);

/// How many solids a STEP file describes, each once however often it is placed.
int count_solids_in_step(std::string_view text);

} // namespace spricka::mesh
