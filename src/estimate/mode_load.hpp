// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "estimate/enrichment.hpp"

namespace spricka::fe {
struct CaseTemperature;
}

namespace spricka::estimate {

/// Consistent loads of one load case on the modes [freedoms]: tractions, pressures, totals,
/// bearings and body forces at the points that consistent_load_vector takes them at, and what its
/// temperatures press. Forces at nodes do no work there.
base::Vector mode_load(const CubicEnrichment& enrichment, const model::LoadCase& load_case,
                       const fe::CaseTemperature& heat);

} // namespace spricka::estimate
