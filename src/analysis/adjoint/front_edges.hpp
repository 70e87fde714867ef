// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "analysis/adjoint/edge_changes.hpp"
#include "analysis/adjoint/frozen_step.hpp"

namespace spricka::analysis {

/// Of the step that was solved last; rows of bonded contacts and of those of single nodes stay.
EdgeChanges edge_changes(const Scene& scene, const FrozenStep& step, const FrontFunctionals& K);

} // namespace spricka::analysis
