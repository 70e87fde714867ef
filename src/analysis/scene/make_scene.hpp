// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "analysis/scene/cut_cracks.hpp"
#include "analysis/scene/scene.hpp"
#include "base/diagnostics.hpp"

#include <optional>
#include <vector>

/// Processor TOPOLOGY: one crack length made ready to be solved.
namespace spricka::analysis {

/// Mesh with cracks of length `a`, classes of freedoms, contact rows, virtual extension fields.
/// Mistakes that only show here (a crack that touches no element, surfaces that never face each
/// other) go to `diagnostics` at their card and give an empty result.
std::optional<Discretisation> discretise(const model::Model& model, double a,
                                         const CrackRegionPlan& plan,
                                         base::Diagnostics& diagnostics);

/// The same with the cracks as given.
std::optional<Discretisation> discretise(const model::Model& model,
                                         const std::vector<mesh::CrackLine>& lines,
                                         const CrackRegionPlan& plan,
                                         base::Diagnostics& diagnostics);

/// Marks the elements of the host that no crack of the plan will touch.
void mark_rest_elements(const CrackRegionPlan& plan, Discretisation& scene);

} // namespace spricka::analysis
