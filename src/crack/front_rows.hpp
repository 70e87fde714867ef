// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "crack/front_forces.hpp"
#include "crack/k_layout.hpp"
#include "crack/supplementary_functions.hpp"

/// K along a front as linear functions.
namespace spricka::crack {

/// K1, K2 and K3 of all points as functions of u, rows^T u + what loads add: what front_intensity
/// finds. The rows are their exact gradient, columns as in KLayout. [3 * node, 3 * points]
SparseRows front_intensity_rows(const model::Model& model, const mesh::CrackedMesh& cracked,
                                const mesh::CrackFront& front, const FrontExtensions& fields);

/// K as functions of what multiplies other functions, 3 * function + direction: the same functional
/// as front_intensity_rows. [3 * count, 3 * points]
SparseRows supplementary_front_rows(const model::Model& model, const mesh::CrackedMesh& cracked,
                                    const mesh::CrackFront& front, const FrontExtensions& fields,
                                    const SupplementaryFunctions& others);

/// What forces at the points of `places`, one after another, add to K; the forces that these have
/// do not matter. [3 * point of a side, 3 * points]
SparseRows front_force_rows(const model::Model& model, const mesh::CrackedMesh& cracked,
                            const mesh::CrackFront& front, const FrontExtensions& fields,
                            const std::vector<FacePointForces>& places);

} // namespace spricka::crack
