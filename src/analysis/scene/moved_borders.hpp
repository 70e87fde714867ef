// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/diagnostics.hpp"
#include "mesh/cut/cracked.hpp"
#include "model/forward.hpp"

namespace spricka::analysis {

/// Tells (W425) of face sets of contacts and loads that end elsewhere in a cracked plane mesh than
/// in the deck's: along a line of symmetry a patch divides the crack's part of the line anew.
void warn_of_moved_borders(const model::Model& model, const mesh::CrackedMesh& cracked,
                           base::Diagnostics& diagnostics);

} // namespace spricka::analysis
