// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/id.hpp"
#include "model/forward.hpp"

#include <vector>

namespace spricka::analysis {

/// How many rings of elements the domains of a crack move: those of $VCE, else all from 2 to the
/// last of its tip net, as the first ring alone sees the singular elements only.
std::vector<int> domain_ring_counts(const model::Model& model, base::CrackId crack);

} // namespace spricka::analysis
