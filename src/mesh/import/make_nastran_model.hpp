// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "mesh/import/nastran_model.hpp"

#include <vector>

namespace spricka::mesh {

/// Elements in our order of nodes and right-handed, points in the basic system, a set "P<number>"
/// for each property and one with its name where comments give it, surfaces, sets of supports and
/// loads. What is wrong goes to `complaints`; the model is not to be used
/// then.
NastranModel make_nastran_model(const NastranBulk& bulk, std::vector<NastranIssue>& complaints);

} // namespace spricka::mesh
