// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/diagnostics.hpp"
#include "base/vec.hpp"
#include "model/forward.hpp"
#include "results/load_total.hpp"

#include <vector>

namespace spricka::sense {

/// What the loads of each case come to on the deck's own mesh, cases without forces left out.
/// Temperatures and prescribed displacements are no forces; faces of cracks are not there yet.
std::vector<results::LoadTotal> compute_load_totals(const model::Model& model);

/// Whether one load of a case on a mesh with cracks is a number (E434), and comes to the same total
/// there as on the deck's own mesh (E435); a load whose integral no rule could follow is warned of
/// (W435), and a displacement that the nodes cannot follow (W436). `values`: its consistent nodal
/// load, of a displacement load the nodal displacements [dim * node].
bool check_load_on_cracked_mesh(const model::Model& model, const model::Mesh& cracked,
                                const model::LoadCase& load_case, const model::Load& load,
                                const base::Vector& values, base::Diagnostics& diagnostics);

} // namespace spricka::sense
