// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "analysis/bodies/condensation_request.hpp"

#include <vector>

namespace spricka::analysis {

/// 128-bit hash of all that the condensation of a net depends on: coordinates, connectivity,
/// elastic constants, state, thickness, the classes and order of its freedoms, and the hashes of
/// the nets condensed into it.
HashKey hash_substructure(const model::Model& model, const model::Mesh& mesh,
                          const Substructure& net, const std::vector<HashKey>& parts);

} // namespace spricka::analysis
