// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "analysis/bodies/condense_bodies.hpp"
#include "analysis/scene/scene.hpp"

#include <string>
#include <string_view>

namespace spricka::analysis {

/// Of a refusal that says "body B is loaded but not held" in a step: why the contacts that B has do
/// not hold it there (mounted later, dismounted before, pulled off), as a half sentence that begins
/// with a colon; empty where B has none, or the refusal says something else.
std::string explain_release(const model::Model& model, const Discretisation& scene,
                            const std::vector<SubstructuredBody>& bodies, const model::Step& step,
                            std::string_view refusal);

} // namespace spricka::analysis
