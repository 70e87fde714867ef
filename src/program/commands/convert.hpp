// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/outcome.hpp"
#include "program/job/log.hpp"

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace spricka::program {

struct ConvertOptions {
  std::filesystem::path in;  ///< .msh, .geo, .inp, .step, Nastran bulk data; else a deck
  std::filesystem::path out; ///< .msh, .vtu, .inp; of an .inp .deck
  std::vector<std::pair<std::string, std::string>> defines; ///< for a deck
  LogFormat log_format = LogFormat::text;
  bool replace = false; ///< an OUT that is there already
};

/// Reads a mesh or a deck and writes it in another form, as the name of the output says. Messages
/// go to stderr. Returns deck_error for mistakes in the input, not_solvable for what the output's
/// form cannot say (each card is named). See manual/meshes.md.
base::ProgramOutcome convert_mesh_or_deck(const ConvertOptions& options);

} // namespace spricka::program
