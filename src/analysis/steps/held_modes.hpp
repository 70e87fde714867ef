// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "analysis/bodies/condense_bodies.hpp"
#include "analysis/scene/scene.hpp"
#include "base/outcome.hpp"
#include "model/forward.hpp"
#include "results/preview.hpp"

#include <vector>

namespace spricka::analysis {

/// Which rigid modes of the bodies supports hold, which a contact can feel, which neither does.
std::vector<results::BodyRestraintPreview>
rigid_mode_support(const model::Model& model, const Discretisation& scene,
                   const std::vector<SubstructuredBody>& bodies);

/// Loads that no contact can take, step by step, as the solution would find: of each step the
/// first, as not_solvable. Needs no stiffness.
std::vector<base::OperationFailure> unsupported_loads(const model::Model& model,
                                                      const Discretisation& scene,
                                                      const std::vector<SubstructuredBody>& bodies);

} // namespace spricka::analysis
