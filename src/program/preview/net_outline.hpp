// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "analysis/bodies/condense_bodies.hpp"
#include "model/mesh.hpp"
#include "solve/factor_law.hpp"

namespace spricka::program {

/// What the law of a factor asks of a net, from its elements: unknowns, and how many elements it is
/// long, wide and high. Rows of contact are left at 0, and freedoms of condensed parts count as
/// externals. `condensed` [unknowns] are those.
solve::NetOutline outline_net(const model::Mesh& mesh, const analysis::Substructure& net,
                              std::size_t condensed);

/// Entries of all element matrices of a net: the time of its stiffness goes by them.
double element_matrix_entries(const model::Mesh& mesh, const analysis::Substructure& net);

} // namespace spricka::program
