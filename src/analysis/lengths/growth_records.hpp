// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "analysis/lengths/growth_measure.hpp"
#include "growth/march.hpp"
#include "results/growth.hpp"

namespace spricka::analysis {

/// What a march found, as records: stations, the dense curve up to the end, how it ended.
results::Growth growth_records(const model::Model& model, const growth::March& march,
                               const GrowthMeasure& measure);

} // namespace spricka::analysis
