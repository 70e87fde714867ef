// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "analysis/lengths/growth_measure.hpp"
#include "analysis/lengths/log_writer.hpp"
#include "growth/growth_integrator.hpp"
#include "results/growth.hpp"
#include "results/results.hpp"

#include <cstddef>
#include <vector>

namespace spricka::analysis {

/// The s of the points of a dense curve from the first station to the end of the growth.
std::vector<double> life_curve_places(const growth::GrowthIntegrator& integrator);
/// Cycles from the first of ascending places to each of them.
std::vector<double> cycles_at(const growth::GrowthTrajectory& counted,
                              const std::vector<double>& places);
/// Arms of the first tips at the places of the curve, against cycles [place].
std::vector<results::LifeCurvePoint> life_curve(const growth::GrowthIntegrator& integrator,
                                                const std::vector<double>& cycles,
                                                std::size_t tips);

/// Tells the log of the station that counts last: its first tip and the cycles to it.
void log_last_station(const growth::GrowthIntegrator& integrator, LogWriter& log);

/// What an integrator found, as records: stations, the dense curve up to the end, how it ended.
results::GrowthResult growth_records(const model::Model& model,
                                     const growth::GrowthIntegrator& integrator,
                                     const GrowthRateEvaluator& measure);

/// Sizes of fronts that K shapes: each has the length of its first tip, as stations and N(a) do.
/// Others keep theirs.
void set_front_sizes_from_first_tips(const model::Model& model, const growth::CrackGeometry& cracks,
                                     const std::vector<growth::TrackedTip>& tips,
                                     const growth::SolvedStation& here,
                                     results::CrackLengthResult& increment);

} // namespace spricka::analysis
