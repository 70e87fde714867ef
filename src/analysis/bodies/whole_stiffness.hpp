// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "analysis/scene/scene.hpp"
#include "base/sparse.hpp"
#include "model/forward.hpp"

namespace spricka::analysis {

/// The stiffness of all bodies of a scene in one matrix (lower triangle), ties taken out by
/// elimination, contact left out, nothing external: what a direct finite-element code has to
/// factorise at the least. Every diagonal is larger by 1e-6, as bodies that only contact holds
/// would be singular: the factorisation costs the same.
base::SymmetricCsc regularised_global_stiffness(const model::Model& model,
                                                const Discretisation& scene);

} // namespace spricka::analysis
