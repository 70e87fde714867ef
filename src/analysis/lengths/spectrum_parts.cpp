// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/lengths/spectrum_parts.hpp"

#include "analysis/lengths/place_on_front.hpp"
#include "analysis/steps/history_program.hpp"
#include "life/spectrum_levels.hpp"
#include "model/model.hpp"
#include "model/reduce_spectrum.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>
#include <utility>

namespace spricka::analysis {

namespace {

using growth::SolvedStation;
using growth::TipStation;

model::SpectrumDefinition with_loads(model::SpectrumDefinition spectrum,
                                     const model::UnreducedLoads& loads) {
  spectrum.cycles = loads.cycles;
  spectrum.turning_points = loads.turning_points;
  return spectrum;
}

// The spectrum in other words, each with its name.
std::vector<std::pair<std::string, model::SpectrumDefinition>>
other_readings(const model::SpectrumDefinition& spectrum) {
  std::vector<std::pair<std::string, model::SpectrumDefinition>> others;
  if (spectrum.sequence) {
    const bool pairs = spectrum.counting == model::CycleCounting::pairs;
    others.emplace_back(pairs ? "COUNT=RAINFLOW" : "COUNT=PAIRS", spectrum);
    others.back().second.counting =
        pairs ? model::CycleCounting::rainflow : model::CycleCounting::pairs;
  }
  if (!spectrum.unreduced) {
    return others;
  }
  const model::SpectrumDefinition whole = with_loads(spectrum, *spectrum.unreduced);
  const auto reduced_by = [&](std::optional<double> clip, std::optional<double> omit) {
    model::SpectrumDefinition other = whole;
    other.clip = clip;
    other.omit = omit;
    model::reduce_spectrum(other);
    return other;
  };
  if (spectrum.clip) {
    others.emplace_back("without CLIP", reduced_by(std::nullopt, spectrum.omit));
  }
  if (spectrum.omit) {
    others.emplace_back("without OMIT", reduced_by(spectrum.clip, std::nullopt));
  }
  return others;
}

// What a station's tips have of K over the load.
class StationMaps {
public:
  StationMaps(const model::Model& model, const results::RunResult& run,
              const std::vector<SolvedStation>& stations) {
    for (const results::CrackLengthResult& increment : run.increments) {
      const results::LoadPathResult* path = growth_load_path(model, increment);
      if (path == nullptr || maps_.size() == stations.size()) {
        break;
      }
      std::vector<base::PiecewiseLinear>& of_tips = maps_.emplace_back();
      for (const TipStation& tip : stations[maps_.size() - 1].tips) {
        of_tips.push_back(path_K1_at_nearest_place(*path, {tip.x, tip.y, tip.z})
                              .value_or(base::PiecewiseLinear()));
      }
    }
  }
  [[nodiscard]] std::size_t station_count() const { return maps_.size(); }
  [[nodiscard]] const base::PiecewiseLinear& map(std::size_t station, std::size_t tip) const {
    return maps_[station][tip];
  }

private:
  std::vector<std::vector<base::PiecewiseLinear>> maps_; ///< [station][tip]
};

/// Growth of the same stations by another spectrum: each rate times what that makes of it on the
/// same K.
class SpectrumComparison {
public:
  SpectrumComparison(const StationMaps& maps, const GrowthRateEvaluator& measure,
                     const growth::GrowthIntegrator& integrator)
      : maps_(maps), measure_(measure), stations_(integrator.growth_state().stations),
        end_(integrator.growth_end() ? integrator.growth_end()->s : stations_.back().s) {}

  // Of the life by the spectrum itself; empty: it has none to compare with.
  [[nodiscard]] std::optional<double> life_ratio(const life::CountedSpectrum& other) const {
    std::vector<SolvedStation> changed = stations_;
    for (std::size_t i = 0; i < changed.size(); ++i) {
      for (std::size_t t = 0; t < changed[i].tips.size(); ++t) {
        TipStation& tip = changed[i].tips[t];
        const base::PiecewiseLinear& K = maps_.map(i, t);
        const model::PlaceOnCrack place = growth::place_of_tip(tip, tip.a);
        const double own = measure_.spectrum()->growth_per_pass(measure_.law(), K, place);
        const double by_other = other.growth_per_pass(measure_.law(), K, place);
        tip.rate = own > 0.0 ? tip.rate * by_other / own : tip.rate;
      }
      if (!(changed[i].growth_rate() > 0.0) || !std::isfinite(changed[i].growth_rate())) {
        return std::nullopt;
      }
    }
    const double ratio = life(changed) / life(stations_);
    return std::isfinite(ratio) ? std::optional(ratio) : std::nullopt;
  }

  /// Parts of growth and of life for each of `cycles`; empty: K turns within the loads.
  [[nodiscard]] std::optional<life::PartsOfCycles> parts() const;

private:
  [[nodiscard]] double life(const std::vector<SolvedStation>& stations) const {
    return growth::GrowthTrajectory(stations, {}, 4).cycles(stations.front().s, end_);
  }

  const StationMaps& maps_;
  const GrowthRateEvaluator& measure_;
  const std::vector<SolvedStation>& stations_;
  double end_;
};

// Growth of each cycle at a station, over all tips, as a part of that of a pass.
std::optional<std::vector<double>> parts_at_station(const StationMaps& maps,
                                                    const GrowthRateEvaluator& measure,
                                                    const SolvedStation& station, std::size_t i) {
  std::vector<double> parts;
  double sum = 0.0;
  for (std::size_t t = 0; t < station.tips.size(); ++t) {
    const TipStation& tip = station.tips[t];
    const std::vector<double> grown = measure.spectrum()->growth_by_cycle(
        measure.law(), maps.map(i, t), growth::place_of_tip(tip, tip.a));
    if (grown.empty()) {
      return std::nullopt;
    }
    parts.resize(grown.size(), 0.0);
    for (std::size_t k = 0; k < grown.size(); ++k) {
      parts[k] += grown[k];
      sum += grown[k];
    }
  }
  if (!(sum > 0.0) || !std::isfinite(sum)) {
    return std::nullopt;
  }
  for (double& part : parts) {
    part /= sum;
  }
  return parts;
}

std::optional<life::PartsOfCycles> SpectrumComparison::parts() const {
  life::PartsOfCycles all;
  const growth::GrowthTrajectory between(stations_, {}, 4);
  const double length = end_ - stations_.front().s;
  const double cycles = between.cycles(stations_.front().s, end_);
  if (!(length > 0.0) || !(cycles > 0.0) || !std::isfinite(cycles)) {
    return std::nullopt;
  }
  std::optional<std::vector<double>> before;
  for (std::size_t i = 0; i < stations_.size(); ++i) {
    std::optional<std::vector<double>> here = parts_at_station(maps_, measure_, stations_[i], i);
    if (!here) {
      return std::nullopt;
    }
    all.growth.resize(here->size(), 0.0);
    all.life.resize(here->size(), 0.0);
    if (i > 0 && stations_[i - 1].s < end_) {
      // The last station may lie beyond the end: the mean of both ends stands for what is before.
      const double to = std::min(stations_[i].s, end_);
      const double of_length = (to - stations_[i - 1].s) / length;
      const double of_life = between.cycles(stations_[i - 1].s, to) / cycles;
      for (std::size_t k = 0; k < here->size(); ++k) {
        const double part = 0.5 * ((*before)[k] + (*here)[k]);
        all.growth[k] += of_length * part;
        all.life[k] += of_life * part;
      }
    }
    before = std::move(here);
  }
  return all;
}

std::vector<results::SpectrumLevel> results_of(const std::vector<life::CycleLevel>& levels) {
  std::vector<results::SpectrumLevel> out;
  out.reserve(levels.size());
  for (const life::CycleLevel& level : levels) {
    out.push_back({.low = level.low,
                   .high = level.high,
                   .cycles = level.cycles,
                   .reached = level.reached,
                   .crossed = level.crossed,
                   .growth = level.growth,
                   .life = level.life});
  }
  return out;
}

} // namespace

results::SpectrumParts find_spectrum_parts(const model::Model& model, const results::RunResult& run,
                                           const growth::GrowthIntegrator& integrator,
                                           const GrowthRateEvaluator& measure) {
  results::SpectrumParts out;
  if (!measure.spectrum()) {
    return out;
  }
  const model::SpectrumDefinition& spectrum = model.spectra[*model.growth->spectrum];
  const std::vector<SolvedStation>& stations = integrator.growth_state().stations;
  const bool mapped = !depends_on_load_order(model) && stations.size() > 1;
  const StationMaps maps(model, run, mapped ? stations : std::vector<SolvedStation>());
  std::optional<SpectrumComparison> comparison;
  if (mapped && maps.station_count() == stations.size()) {
    comparison.emplace(maps, measure, integrator);
  }
  for (const auto& [name, other] : other_readings(spectrum)) {
    const life::CountedSpectrum counted = life::CountedSpectrum::from_definition(other);
    out.others.push_back(
        {.name = name,
         .cycles_per_pass = counted.cycles_per_pass(),
         .ratio = comparison ? comparison->life_ratio(counted) : std::optional<double>()});
  }
  const std::optional<life::PartsOfCycles> parts =
      comparison ? comparison->parts() : std::optional<life::PartsOfCycles>();
  const std::vector<life::LoadCycle> cycles = measure.spectrum()->cycles();
  out.peaks = results_of(life::sort_by_peak(cycles, parts));
  out.ranges = results_of(life::sort_by_range(cycles, parts));
  return out;
}

} // namespace spricka::analysis
