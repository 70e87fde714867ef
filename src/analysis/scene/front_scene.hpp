// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "analysis/scene/scene.hpp"
#include "base/diagnostics.hpp"

namespace spricka::analysis {

/// Gives each front of the cut mesh the domains that fit round it, and those in space the size of
/// their crack. Errors (no domain fits round a tip, or a point of a front inside the body) go to
/// the crack's card; false where there was one.
bool assign_front_domains(const model::Model& model, Discretisation& scene,
                          base::Diagnostics& diagnostics);

} // namespace spricka::analysis
