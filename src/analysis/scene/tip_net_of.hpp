// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/id.hpp"
#include "model/forward.hpp"

namespace spricka::analysis {

/// The settings of a crack's tips; null: none are given.
const model::TipMeshSettings* find_tip_net(const model::Model& model, base::CrackId crack);

} // namespace spricka::analysis
