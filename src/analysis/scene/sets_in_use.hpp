// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "mesh/tube/set_use.hpp"

namespace spricka::model {
struct Model;
}

namespace spricka::analysis {

/// What a model does with the sets of its mesh: they hold, load, touch, tie, or are asked for by
/// name. Groups of imported meshes that nothing names are not used.
mesh::SetUsage sets_in_use(const model::Model& model);

} // namespace spricka::analysis
