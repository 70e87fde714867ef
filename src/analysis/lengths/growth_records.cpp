// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/lengths/growth_records.hpp"

#include "analysis/adjoint/error_bars_base.hpp"
#include "analysis/lengths/pass_counter.hpp"
#include "analysis/steps/history_program.hpp"
#include "base/tidy.hpp"
#include "model/model.hpp"
#include "results/result_unit.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>

#include <fmt/format.h>

namespace spricka::analysis {

namespace {

results::LifeCurvePoint point_at(const growth::GrowthTrajectory& between, double s, double cycles,
                                 std::size_t tips) {
  results::LifeCurvePoint point;
  point.cycles = cycles;
  for (std::size_t tip = 0; tip < tips; ++tip) {
    point.a.push_back(base::restore_short_decimal(between.crack_extent(tip, s)));
  }
  return point;
}

// Cycles of a pass that have at least a range, for the ranges there are: of more than a curve can
// show one for each part of the logarithm of their number.
std::vector<std::array<double, 2>> ranges_of(const life::CountedSpectrum& spectrum) {
  constexpr double parts = 200.0; // of the logarithm to base 10
  std::map<double, double, std::greater<>> by_range;
  for (const life::LoadCycle& cycle : spectrum.cycles()) {
    by_range[cycle.high - cycle.low] += cycle.count;
  }
  std::vector<std::array<double, 2>> ranges;
  double sum = 0.0;
  double reported = 0.0;
  for (const auto& [range, count] : by_range) {
    sum += count;
    // One point for each 1/200 of a decade of the number of cycles, and the last.
    const double part = std::floor(parts * std::log10(sum));
    if (ranges.empty() || part > reported || range == by_range.rbegin()->first) {
      ranges.push_back({range, sum});
      reported = part;
    }
  }
  return ranges;
}

results::GrownPointResult record_of(const std::string& name, const growth::TipStation& t) {
  return {.name = name,
          .a = base::restore_short_decimal(t.a),
          .K_max = t.K_max,
          .K_min = t.K_min,
          .K2_max = t.K2_max,
          .rate = t.rate,
          .turn = t.turn,
          .x = base::Vec3(t.x, t.y, t.z),
          .first_max = t.first_max,
          .first_min = t.first_min};
}

// What the law was asked for in all cycles of the growth, at all points. The cycles between two
// stations count half as those of the one and half as those of the other.
model::LawUse law_use_of_growth(const std::vector<growth::SolvedStation>& stations,
                                const std::vector<results::GrowthStation>& records,
                                double all_cycles) {
  model::LawUse all;
  double cycles = 0.0;
  double growth = 0.0;
  const auto until_end = [&](std::size_t i) { return std::min(records[i].cycles, all_cycles); };
  for (std::size_t i = 0; i < stations.size(); ++i) {
    const double before = i > 0 ? until_end(i) - until_end(i - 1) : 0.0;
    const double after = i + 1 < stations.size() ? until_end(i + 1) - until_end(i) : 0.0;
    const double here = stations.size() == 1 ? 1.0 : 0.5 * (before + after);
    for (const growth::TipStation& tip : stations[i].tips) {
      const model::LawUse& use = tip.law_use;
      if (!(here > 0.0) || use.lowest_delta_k > use.highest_delta_k) {
        continue;
      }
      all.lowest_delta_k = std::min(all.lowest_delta_k, use.lowest_delta_k);
      all.highest_delta_k = std::max(all.highest_delta_k, use.highest_delta_k);
      all.lowest_ratio = std::min(all.lowest_ratio, use.lowest_ratio);
      all.highest_ratio = std::max(all.highest_ratio, use.highest_ratio);
      const double grown = std::isfinite(tip.rate) ? here * tip.rate : 0.0;
      cycles += here;
      growth += grown;
      all.outside += here * use.outside;
      all.growth_outside += grown * use.growth_outside;
      all.below_delta_k += here * use.below_delta_k;
      all.above_delta_k += here * use.above_delta_k;
      all.below_ratio += here * use.below_ratio;
      all.above_ratio += here * use.above_ratio;
    }
  }
  for (double model::LawUse::*part :
       {&model::LawUse::outside, &model::LawUse::below_delta_k, &model::LawUse::above_delta_k,
        &model::LawUse::below_ratio, &model::LawUse::above_ratio}) {
    all.*part = cycles > 0.0 ? all.*part / cycles : 0.0;
  }
  all.growth_outside = growth > 0.0 ? all.growth_outside / growth : 0.0;
  return all;
}

// Of the tip that is nearest to growing at a station where none grows: its delta K, R, and the
// threshold of that R.
std::string threshold_words(const model::Model& model, const std::vector<std::string>& names,
                            const growth::SolvedStation& station, const life::GrowthRateLaw& law) {
  double nearest = 0.0;
  std::string words;
  for (std::size_t i = 0; i < names.size(); ++i) {
    const growth::TipStation& tip = station.tips[i];
    const double range = life::tensile_K_range(tip.K_max, tip.K_min);
    if (!(tip.K_max > 0.0) || !(range > 0.0)) {
      continue;
    }
    const double R = tip.K_min / tip.K_max;
    const double least = law.threshold(R, growth::place_of_tip(tip, tip.a));
    if (range / least > nearest) {
      nearest = range / least;
      words = fmt::format(" ({}: delta K = {:.4g}, R = {:.3g}, threshold {:.4g} {})", names[i],
                          range, R, least, model.units.stress_intensity_name());
    }
  }
  return words;
}

} // namespace

std::vector<double> life_curve_places(const growth::GrowthIntegrator& integrator) {
  constexpr int points = 16; // between two stations
  const std::vector<growth::SolvedStation>& stations = integrator.growth_state().stations;
  const double end = integrator.growth_end() ? integrator.growth_end()->s : stations.back().s;
  std::vector<double> places{stations.front().s};
  for (std::size_t i = 0; i + 1 < stations.size(); ++i) {
    const double last = std::min(stations[i + 1].s, end);
    for (int k = 1; k <= points && places.back() < last; ++k) {
      places.push_back(k == points ? last : stations[i].s + (last - stations[i].s) * k / points);
    }
  }
  return places;
}

std::vector<double> cycles_at(const growth::GrowthTrajectory& counted,
                              const std::vector<double>& places) {
  std::vector<double> cycles{0.0};
  for (std::size_t k = 1; k < places.size(); ++k) {
    cycles.push_back(cycles.back() + counted.cycles(places[k - 1], places[k]));
  }
  return cycles;
}

std::vector<results::LifeCurvePoint> life_curve(const growth::GrowthIntegrator& integrator,
                                                const std::vector<double>& cycles,
                                                std::size_t tips) {
  const std::vector<double> places = life_curve_places(integrator);
  const growth::GrowthTrajectory between = integrator.trajectory();
  std::vector<results::LifeCurvePoint> curve;
  for (std::size_t k = 0; k < places.size(); ++k) {
    curve.push_back(point_at(between, places[k], cycles[k], tips));
  }
  return curve;
}

void log_last_station(const growth::GrowthIntegrator& integrator, LogWriter& log) {
  const std::vector<growth::SolvedStation>& stations = integrator.growth_state().stations;
  const growth::SolvedStation& here = stations.back();
  const growth::TipStation& tip = here.tips.front();
  log.add_line("GROW",
               fmt::format("station {}: a = {:.6g}, K {:.6g} .. {:.6g}, da/dN = {:.4g}, N = {:.6g}",
                           stations.size(), tip.a, tip.K_min, tip.K_max, tip.rate,
                           integrator.trajectory().cycles(stations.front().s, here.s)));
}

namespace {

struct CycleCounts {
  std::vector<double> at_places; ///< of the dense curve
  std::vector<double> at_stations;
};

CycleCounts count_cycles(const growth::GrowthIntegrator& integrator,
                         const GrowthRateEvaluator& measure) {
  const std::vector<growth::SolvedStation>& stations = integrator.growth_state().stations;
  const growth::GrowthTrajectory between = integrator.trajectory();
  const std::vector<double> places = life_curve_places(integrator);
  CycleCounts counts;
  if (!measure.interaction()) {
    std::vector<double> at;
    at.reserve(stations.size());
    for (const growth::SolvedStation& station : stations) { // also behind the end
      at.push_back(station.s);
    }
    return {.at_places = cycles_at(between, places), .at_stations = cycles_at(between, at)};
  }
  std::vector<double> all = places;
  if (stations.back().s > places.back()) {
    all.push_back(stations.back().s);
  }
  std::vector<double> passes =
      PassCounter(*measure.spectrum(), *measure.interaction()).passes_at(stations, all);
  for (const growth::SolvedStation& station : stations) {
    const auto place = std::ranges::lower_bound(all, station.s);
    counts.at_stations.push_back(passes[static_cast<std::size_t>(place - all.begin())]);
  }
  passes.resize(places.size());
  counts.at_places = std::move(passes);
  return counts;
}

// What a reader has to know of how cycles act on each other.
std::vector<std::string> interaction_words(const model::Model& model,
                                           const std::vector<growth::SolvedStation>& stations,
                                           const GrowthRateEvaluator& measure, double passes) {
  std::vector<std::string> words{"Cycles act on each other by " +
                                 describe_interaction(model, *measure.interaction(), stations)};
  words.emplace_back(PassCounter(*measure.spectrum(), *measure.interaction())
                             .has_followed_each_cycle(stations, passes)
                         ? "Each cycle was followed, in the order of the spectrum"
                         : "Passes were counted by what a pass grows at the solved lengths once "
                           "it is like the one before");
  const auto& rules = model.growth->interactions;
  for (std::size_t i = 1; i < rules.size(); ++i) {
    words.push_back("Beside it " +
                    describe_interaction(model, make_load_interaction(model, rules[i]), stations));
  }
  return words;
}

} // namespace

results::GrowthResult growth_records(const model::Model& model,
                                     const growth::GrowthIntegrator& integrator,
                                     const GrowthRateEvaluator& measure) {
  results::GrowthResult out;
  out.unit = measure.spectrum() ? "pass" : "cycle";
  out.corrected = corrects_K(model);
  out.followed = depends_on_load_order(model);
  if (measure.spectrum()) {
    out.cycles_per_pass = measure.spectrum()->cycles_per_pass();
    out.ranges = ranges_of(*measure.spectrum());
    results::set_life_unit(model.spectra[*model.growth->spectrum], out);
    out.counted = depends_on_load_order(model)   ? "K, followed through the loads in their order"
                  : measure.counts_cycles_on_K() ? "K, which turns within the loads"
                                                 : "loads";
  }
  for (const growth::TrackedTip& tip : integrator.tips()) {
    out.point_names.push_back(tip.name);
  }
  const std::vector<growth::SolvedStation>& stations = integrator.growth_state().stations;
  const CycleCounts counts = count_cycles(integrator, measure);
  out.curve = life_curve(integrator, counts.at_places, out.point_names.size());
  if (measure.interaction()) {
    out.interaction = interaction_words(model, stations, measure, counts.at_places.back());
  }
  for (std::size_t i = 0; i < stations.size(); ++i) {
    results::GrowthStation station;
    station.increment = static_cast<int>(i) + 1;
    station.cycles = counts.at_stations[i];
    if (stations[i].breakthroughs > 0) {
      const std::size_t met = stations[i].met;
      out.passages.push_back(fmt::format(
          "{} {} between stations {} and {}, at {:.6g} {}{}",
          out.point_names[stations[i].breakthroughs - 1],
          met > 0
              ? fmt::format("meets crack {}, and the two go on as one", model.cracks[met - 1].name)
              : "goes through a surface",
          i, i + 1, station.cycles, out.unit == "pass" ? "passes" : "cycles",
          measure.interaction() ? "; what it remembered of overloads ends there" : ""));
    }
    for (std::size_t tip = 0; tip < out.point_names.size(); ++tip) {
      const growth::TipStation& t = stations[i].tips[tip];
      station.points.push_back(record_of(out.point_names[tip], t));
      station.passes = std::max(station.passes, static_cast<int>(t.passes));
      station.change = std::max(station.change, t.change);
    }
    out.stations.push_back(std::move(station));
  }
  if (integrator.growth_end()) {
    out.ended = integrator.growth_end()->word();
    out.reason = integrator.growth_end()->reason;
    if (integrator.growth_end()->kind == growth::GrowthEventKind::threshold &&
        !measure.spectrum()) {
      out.reason += threshold_words(model, out.point_names, stations.back(), measure.law());
    }
  }
  out.error = integrator.cycle_error();
  out.law_use = law_use_of_growth(stations, out.stations, out.final_cycles());
  return out;
}

void set_front_sizes_from_first_tips(const model::Model& model, const growth::CrackGeometry& cracks,
                                     const std::vector<growth::TrackedTip>& tips,
                                     const growth::SolvedStation& here,
                                     results::CrackLengthResult& increment) {
  if (cracks.solids.empty() || model.growth->shape != model::FrontShapeRule::free) {
    return;
  }
  // Backwards, so that the first tip of a front is the one that stays.
  for (std::size_t t = tips.size(); t-- > 0;) {
    const double a = base::restore_short_decimal(here.tips[t].a);
    const std::string& crack = cracks.solid_crack_at_tip(t).name;
    results::for_each_front(increment, [&](results::FrontResult& front) {
      if (front.name == crack || front.name.starts_with(crack + ".")) {
        front.a = a;
      }
    });
    increment.a = a;
  }
}

} // namespace spricka::analysis
