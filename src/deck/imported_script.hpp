// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/source.hpp"
#include "mesh/import/script_scan.hpp"

#include <string>
#include <vector>

namespace spricka::deck {

/// The constants of one geometry script that a deck has imported, in the order of the script.
struct ImportedScript {
  std::string file;
  std::string net;
  base::SourceSpan card;
  std::vector<mesh::GeometryScriptConstant> constants;
};

} // namespace spricka::deck
