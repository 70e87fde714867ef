// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "analysis/scene/scene.hpp"
#include "base/diagnostics.hpp"
#include "crack/front_setting.hpp"

namespace spricka::analysis {

/// Takes the fronts of cracks in space out of the cut mesh, with the domains that fit round them.
/// Errors (no domain fits round a point of a front inside the body) go to the crack's card.
bool make_fronts(const model::Model& model, Discretisation& scene, base::Diagnostics& diagnostics);

/// The same as tip_loads, of all domains of a front.
crack::TipLoads front_loads(const model::Model& model, const Discretisation& scene,
                            const crack::FrontExtensions& fields, const base::Vector& case_factor);

/// What the domains of a front must keep clear of: nodes that are held or loaded one by one, but
/// for those of a flat part of the surface that is held across, which they move along.
crack::DomainLimits front_limits(const model::Model& model, const Discretisation& scene);

} // namespace spricka::analysis
