// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/id.hpp"
#include "model/forward.hpp"

namespace spricka::analysis {

/// The settings of a crack's tips; null: none are given.
const model::TipMeshSettings* find_tip_mesh_settings(const model::Model& model,
                                                     base::CrackId crack);

} // namespace spricka::analysis
