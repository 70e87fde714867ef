// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/diagnostics.hpp"
#include "model/forward.hpp"
#include "results/preview.hpp"

#include <string>

/// One side of a plane of symmetry in the place of the whole model.
namespace spricka::sense {

/// Leaves one side of every plane of `model.mirrors`: elements, sets, contacts, cracks and loads of
/// the other side go, nodes in the plane are held across it, and loads that lie on both sides are
/// given by what of them acts on the side that stays. A crack drawn across the plane of a plane
/// model begins in it. Reported (E354): what is not its own mirror image,
/// elements that lie across the plane, and what has no half.
void reduce_to_half_model(model::Model& model, base::Diagnostics& list);

/// Why one side of a plane of symmetry, in which all is its own mirror image, cannot be kept alone;
/// empty: it can.
std::string half_model_obstacle(const model::Model& model,
                                const results::SymmetryPlanePreview& mirror);

} // namespace spricka::sense
