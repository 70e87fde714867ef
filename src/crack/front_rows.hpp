// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "crack/front_extension.hpp"
#include "crack/front_loads.hpp"
#include "crack/k_layout.hpp"
#include "crack/supplementary_functions.hpp"
#include "model/cracks.hpp"

/// K along a front as linear functions.
namespace spricka::crack {

/// K of all points of a front as functions of u, rows^T u + what loads add: what front_intensity
/// finds without a shift. The rows are their exact gradient, columns as in KLayout; zero without a
/// domain and at a tip between two materials. [dim * node, dim * points]
SparseLinearFunctionals
front_intensity_functionals(const model::Model& model, const mesh::CrackedMesh& cracked,
                            const mesh::CrackFront& front, const FrontIntegralDomains& domains,
                            model::CrackTipPlaneState state = model::CrackTipPlaneState::automatic);

/// The same along a front in space, and K as functions of what multiplies other functions, 3 *
/// function + direction, by the same functional: the domains are visited once for both.
IntensityFunctionals supplemented_intensity_functionals(const model::Model& model,
                                                        const mesh::CrackedMesh& cracked,
                                                        const mesh::CrackFront& front,
                                                        const FrontIntegralDomains& fields,
                                                        const SupplementaryFunctions& others);

/// What forces at the points of `places`, one after another, add to K; the forces that these have
/// do not matter. [3 * point of a side, 3 * points]
SparseLinearFunctionals face_force_front_functionals(const model::Model& model,
                                                     const mesh::CrackedMesh& cracked,
                                                     const mesh::CrackFront& front,
                                                     const FrontIntegralDomains& fields,
                                                     const std::vector<FacePointForces>& places);

} // namespace spricka::crack
