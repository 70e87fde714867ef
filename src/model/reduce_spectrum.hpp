// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "model/forward.hpp"

#include <span>
#include <vector>

namespace spricka::model {

/// The history without its small ranges: closed ranges of the pass, which repeats, below `least`
/// are left out, the smallest first; what is left keeps its order. The rainflow count of the rest
/// is that of the history without its cycles below `least`.
std::vector<double> leave_out_small_ranges(std::span<const double> history, double least);

/// Brings loads above SpectrumDefinition::clip down to it, then leaves out cycles with a range
/// below SpectrumDefinition::omit, where the definition has these; the loads as they were are in
/// SpectrumDefinition::unreduced. Without either the definition stays as it is.
void reduce_spectrum(SpectrumDefinition& spectrum);

} // namespace spricka::model
