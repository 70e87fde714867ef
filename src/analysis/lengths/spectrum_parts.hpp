// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "analysis/lengths/growth_measure.hpp"
#include "growth/growth_integrator.hpp"
#include "results/growth.hpp"

namespace spricka::analysis {

/// The levels and ranges of the spectrum of a growth with their parts of growth and life, and the
/// lives by the other count of cycles and without what CLIP and OMIT change: by K of the load paths
/// at the stations, without interaction of cycles. Empty without a spectrum; parts and lives are
/// missing where friction leaves no K over the load.
results::SpectrumParts find_spectrum_parts(const model::Model& model, const results::RunResult& run,
                                           const growth::GrowthIntegrator& integrator,
                                           const GrowthRateEvaluator& measure);

} // namespace spricka::analysis
