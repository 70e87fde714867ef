// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "analysis/lengths/growth_measure.hpp"
#include "growth/growth_integrator.hpp"
#include "model/forward.hpp"
#include "results/results.hpp"

#include <vector>

namespace spricka::analysis {

/// The growth once more by what one K of each length makes of it, for comparison: "scaled", K
/// proportional to the load through the largest one, and of a spectrum "line", K on a line from
/// the beginning of its load path to the largest load. Left out: what is the growth itself (K is
/// such a line), loads that no factor joins, growth of several tips in the plane or with friction.
/// In space it goes through the same fronts.
std::vector<results::ComparedLife>
lives_by_proportional_K(const model::Model& model, const results::RunResult& run,
                        const growth::GrowthIntegrator& integrator,
                        const GrowthRateEvaluator& measure);

/// The growth once more by each of the other rules of how its cycles act on each other, over the
/// same stations.
std::vector<results::ComparedLife>
lives_by_other_interactions(const model::Model& model, const growth::GrowthIntegrator& integrator,
                            const GrowthRateEvaluator& measure);

} // namespace spricka::analysis
