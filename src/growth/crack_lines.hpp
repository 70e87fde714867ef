// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/diagnostics.hpp"
#include "mesh/cut/cracked.hpp"
#include "model/cracks.hpp"
#include "model/forward.hpp"

#include <optional>
#include <vector>

/// From the deck's cracks to lines of a given length on the host.
namespace spricka::growth {

/// Lengths of the growth loop: those of $GROW, or each crack's first length once, or a single 0
/// without cracks.
std::vector<double> growth_loop_crack_lengths(const model::Model& model);

/// All cracks at one increment: those that grow have length `a`, the others (and all when a = 0)
/// their first length. Directions follow the deck: along the path, along the polyline (its last
/// segment goes on), or along ANGLE. Cracks that do not fit (path shorter than a, no length given,
/// tip not on a node with PATCH=NO) are reported at their card and give an empty result. In space
/// there are none.
std::optional<std::vector<mesh::CrackLine>> crack_lines(const model::Model& model, double a,
                                                        base::Diagnostics& diagnostics);

/// The lengths of a crack to both of its tips; one from the boundary has `last` only. Those of an
/// embedded one are its halves, and grow apart by a law [length].
struct CrackLengthsByTip {
  double first = 0.0, last = 0.0;
  bool given = false; ///< by the deck, one length for both
};
/// The same, each crack with its own lengths [crack]; 0: its first length.
std::optional<std::vector<mesh::CrackLine>> crack_lines(const model::Model& model,
                                                        const std::vector<CrackLengthsByTip>& arms,
                                                        base::Diagnostics& diagnostics);

/// The cracks in space where sizes are given: ellipses that grow have the semi-axis A = a, and C in
/// its ratio to it; all as they are first when a = 0.
std::vector<model::CrackDefinition> resize_solid_cracks(const model::Model& model, double a);

/// Whether $GROW names a crack, or all.
bool is_growing_crack(const model::Model& model, std::size_t crack);

} // namespace spricka::growth
