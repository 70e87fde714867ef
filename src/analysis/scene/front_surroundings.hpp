// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "analysis/scene/scene.hpp"
#include "crack/extension.hpp"
#include "crack/front_extension.hpp"
#include "crack/front_loads.hpp"

#include <vector>

namespace spricka::analysis {

/// What acts on the elements and faces of a front's domains under the cases' factors [case]. The
/// model must outlive it.
crack::FrontLoads collect_front_loads(const model::Model& model, const Discretisation& scene,
                                      const crack::FrontIntegralDomains& domains,
                                      const base::Vector& case_factor);

/// Elements between which a domain cannot tell apart: of properties that differ in nothing but
/// their sets they have the same number. [element]
std::vector<std::int64_t> assign_material_zone_numbers(const model::Model& model,
                                                       const model::Mesh& mesh);

/// What the domains of a front must keep clear of: nodes that are held, tied or loaded one by one
/// (in the plane those of a half model's own line are not, in space not those of a flat part of the
/// surface that is held across or along, which they move in), in the plane also the rims of what is
/// heated and the axis.
crack::IntegrationDomainConstraints find_domain_exclusions(const model::Model& model,
                                                           const Discretisation& scene,
                                                           const mesh::CrackFront& front);

/// Puts the faces of all cracks into the sets that loads name.
void fill_crack_face_sets(const model::Model& model, mesh::CrackedMesh& cracked);

/// Loads that give a total to faces of a crack are refused (E417): it spreads anew as the crack
/// grows, which G has no term for.
bool reject_total_loads_on_crack_faces(const model::Model& model, const Discretisation& scene,
                                       base::Diagnostics& diagnostics);

} // namespace spricka::analysis
