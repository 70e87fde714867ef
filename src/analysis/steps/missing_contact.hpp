// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "analysis/bodies/condense_bodies.hpp"
#include "analysis/scene/scene.hpp"

#include <string>

namespace spricka::analysis {

/// Of a body that nothing holds: the body next to it that no contact of the deck joins it with, and
/// the face sets that touch, as a half sentence that begins with a colon; empty: there is none.
std::string explain_unjoined_neighbour(const model::Model& model, const Discretisation& scene,
                                       const std::vector<SubstructuredBody>& bodies,
                                       std::size_t body);

} // namespace spricka::analysis
