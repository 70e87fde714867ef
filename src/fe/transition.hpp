// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "fe/dependence.hpp"
#include "fe/tie_trouble.hpp"
#include "model/freedoms.hpp"

namespace spricka::fe {

/// Ties of one $MPC TYPE=TRANSITION, see make_ties.
void tie_slaves_to_master_faces(const model::Mesh& mesh, const model::TransitionTie& transition,
                                std::size_t mpc, std::vector<Tie>& ties,
                                std::vector<TieFailure>& troubles);

} // namespace spricka::fe
