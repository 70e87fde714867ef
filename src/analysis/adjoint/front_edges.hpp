// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "analysis/adjoint/edge_changes.hpp"
#include "analysis/adjoint/frozen_step.hpp"

namespace spricka::analysis {

/// Of the step that was solved last; rows of bonded contacts and of those of single nodes stay.
ContactEdgeKChange contact_edge_K_changes(const Discretisation& scene,
                                          const FrozenContactStep& step, const KFunctionals& K);

} // namespace spricka::analysis
