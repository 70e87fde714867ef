// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/diagnostics.hpp"
#include "model/forward.hpp"
#include "results/load_total.hpp"

#include <vector>

namespace spricka::sense {

/// What the loads of each case come to on the deck's own mesh, cases without forces left out.
/// Temperatures and prescribed displacements are no forces; faces of cracks are not there yet.
std::vector<results::LoadTotal> compute_load_totals(const model::Model& model);

/// Whether the loads on a mesh with cracks are numbers (E434), and those that the deck's own mesh
/// carries come to the same total there (E435). A load whose integral no rule could follow is
/// warned of (W435).
bool check_loads_on_cracked_mesh(const model::Model& model, const model::Mesh& cracked,
                                 base::Diagnostics& diagnostics);

} // namespace spricka::sense
