// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/diagnostics.hpp"
#include "mesh/cut/cracked.hpp"

#include <span>

/// Cracks as lines, before any mesh is looked at.
namespace spricka::mesh {

/// Whether cracks cross, touch or fold back on themselves or meet each other; errors at `span[i]`
/// that say where.
bool check_crack_lines(std::span<const CrackLine> lines, std::span<const base::SourceSpan> spans,
                       base::Diagnostics& diagnostics);

/// Room for a rosette at the tips of a crack as far as other cracks, and the crack's own earlier
/// parts, leave it: the distance to them [deck length]. Infinite where there are none.
double tip_clearance_to_cracks(const CrackLine& line, std::span<const CrackLine> all);

} // namespace spricka::mesh
