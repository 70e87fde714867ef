// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/diagnostics.hpp"
#include "model/forward.hpp"

#include <string>
#include <vector>

/// Cracks in space as the body has them, beside what the deck draws.
namespace spricka::sense {

/// A line for each crack that is cut into solids: its kind, how far it goes along each face of the
/// body, its area. Warns of an ellipse whose centre is neither in the body nor on its surface, or
/// that is wider than the body (W460), of a crack that takes most of its section (W461), of a
/// corner crack on a plane of symmetry (W462), of a point off its drawn front (W463) and of linear
/// elements round a crack (W426). What cannot be placed is left to the cut.
std::vector<std::string> describe_solid_cracks(const model::Model& model, base::Diagnostics& list);

} // namespace spricka::sense
