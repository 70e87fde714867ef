// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "analysis/scene/scene.hpp"
#include "crack/space/front_rows.hpp"

#include <array>
#include <vector>

/// K along the fronts of a scene in space as linear functions, by its KLayout: rows^T u, what
/// contact forces add on sides that the domains move, and what loads add.
namespace spricka::analysis {

/// K as functions of displacements. [3 * node, K]
crack::SparseRows front_K_rows(const model::Model& model, const Discretisation& scene);

/// What a unit of each row of the table adds to K by its traction on sides that domains move
/// (crack_space.9). [K, row]
base::Matrix front_K_by_forces(const model::Model& model, const Discretisation& scene);

/// K of displacements [3 * node] under the cases' factors [case], without contact forces.
base::Vector front_K_values(const model::Model& model, const Discretisation& scene,
                            const base::Vector& u, const base::Vector& case_factor);

/// Whether cases act on what the domains of some front take.
bool acts_on_fronts(const model::Model& model, const Discretisation& scene,
                    const base::Vector& case_factor);

/// Smooth values of K1, K2, K3 of the points of a front from those in `K` [K], of which the front's
/// begin at `first`; at the surface what points further in go on to (crack_space.15,
/// crack_space.16). Linear in K.
std::vector<std::array<double, 3>> smooth_front_K(const FrontWithDomains& at, const base::Vector& K,
                                                  Eigen::Index first);

} // namespace spricka::analysis
