// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "analysis/bodies/condense_bodies.hpp"
#include "contact/system.hpp"
#include "results/results.hpp"

#include <optional>
#include <vector>

namespace spricka::analysis {

/// Forces on rigid motions by which round and plane surfaces slide on themselves, which contact
/// forces leave over because their normals are those of the other side's elements [size = dim *
/// nodes]; empty: there are none. `condensed`: the solved ones of `bodies`.
base::Vector sliding_mode_residual_force(const std::vector<SubstructuredBody>& bodies,
                                         const std::vector<std::size_t>& condensed,
                                         const contact::ContactSystem::IncrementSolution& solution,
                                         Eigen::Index size);

/// What is to be said of them beside the contact forces, if they are more than round-off.
std::optional<results::Note> residual_force_note(const base::Vector& resting,
                                                 const base::Vector& contact);

} // namespace spricka::analysis
