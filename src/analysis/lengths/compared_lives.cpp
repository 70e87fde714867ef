// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/lengths/compared_lives.hpp"

#include "analysis/lengths/growth_records.hpp"
#include "analysis/lengths/pass_counter.hpp"
#include "analysis/lengths/place_on_front.hpp"
#include "analysis/steps/history_program.hpp"
#include "analysis/steps/step_factors.hpp"
#include "model/model.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace spricka::analysis {

namespace {

constexpr double same_life = 2e-3; // a line that says this is no other one

std::vector<base::Vector> loads_of_steps(const model::Model& model) {
  const auto cases = static_cast<Eigen::Index>(model.cases.size());
  StepActionFactors now = initial_step_factors(model, cases, model.contacts.size());
  std::vector<base::Vector> loads;
  for (const model::Step& step : model.steps) {
    apply_step_actions(step, now);
    loads.push_back(now.case_factor);
  }
  return loads;
}

// r with low = r high; empty: there is none.
std::optional<double> ratio_of(const base::Vector& low, const base::Vector& high) {
  if (!(high.norm() > 0.0)) {
    return std::nullopt;
  }
  // Least squares: exact where the loads of both steps are multiples of each other.
  const double r = low.dot(high) / high.squaredNorm();
  const bool joined = (low - r * high).norm() <= 1e-12 * high.norm();
  return joined ? std::optional(r) : std::nullopt;
}

// Rates of all stations, whose K is on `paths` [station], with K on a line from K0 at t = 0 to the
// K of the largest load.
std::optional<std::vector<growth::SolvedStation>>
on_line(const std::vector<results::LoadPathResult>& paths,
        std::vector<growth::SolvedStation> stations, const GrowthRateEvaluator& measure,
        bool through_zero) {
  const double top = measure.spectrum()->highest_load();
  for (std::size_t i = 0; i < stations.size(); ++i) {
    for (growth::TipStation& tip : stations[i].tips) {
      const std::optional<base::PiecewiseLinear> K1 =
          path_K1_at_nearest_place(paths.at(i), {tip.x, tip.y, tip.z});
      if (!K1 || !(top > 0.0)) {
        return std::nullopt;
      }
      const double K0 = through_zero ? 0.0 : (*K1)(0.0);
      base::PiecewiseLinear line({0.0, top}, {K0}, {((*K1)(top)-K0) / top});
      tip.rate = tip.extent_rate_ratio * measure.growth_per_pass(line, place_of_tip(tip, tip.a));
      tip.K_over_path = std::move(line);
    }
    if (!(stations[i].growth_rate() > 0.0)) {
      return std::nullopt;
    }
  }
  return stations;
}

// Cycles at the places of the curve, as the growth itself counts them.
std::vector<double> cycles_of(const growth::GrowthIntegrator& integrator,
                              const std::vector<growth::SolvedStation>& stations,
                              const GrowthRateEvaluator& measure) {
  const std::vector<double> places = life_curve_places(integrator);
  return measure.interaction()
             ? PassCounter(*measure.spectrum(), *measure.interaction()).passes_at(stations, places)
             : cycles_at(growth::GrowthTrajectory(stations, measure.rates_between_stations(), 4),
                         places);
}

// The same of the growth itself.
std::vector<double> own_cycles(const growth::GrowthIntegrator& integrator,
                               const GrowthRateEvaluator& measure) {
  return measure.interaction() ? cycles_of(integrator, integrator.growth_state().stations, measure)
                               : cycles_at(integrator.trajectory(), life_curve_places(integrator));
}

results::ComparedLife compared(std::string name, std::string what,
                               const growth::GrowthIntegrator& integrator,
                               const std::vector<double>& cycles,
                               const std::vector<double>& those_of_the_growth) {
  return {.name = std::move(name),
          .what = std::move(what),
          .ratio = cycles.back() / those_of_the_growth.back(),
          .curve = life_curve(integrator, cycles, 1)};
}

std::string line_words(std::string_view name) {
  return name == results::life_of_scaled_K ? "one K scaled with the load"
                                           : "a line through t = 0 and the largest load";
}

} // namespace

std::vector<results::ComparedLife>
lives_by_proportional_K(const model::Model& model, const results::RunResult& run,
                        const growth::GrowthIntegrator& integrator,
                        const GrowthRateEvaluator& measure) {
  std::vector<results::ComparedLife> out;
  std::vector<growth::SolvedStation> stations = integrator.growth_state().stations;
  if (stations.size() < 2 || depends_on_load_order(model)) {
    return out;
  }
  // Of several tips the rates would change each other's arms; along fronts they are taken on the
  // fronts that the true K has made.
  const std::size_t tips = run.increments.front().steps.front().tip_count();
  if (tips > 0 && integrator.tips().size() > 1) {
    return out;
  }
  const std::vector<double> own = own_cycles(integrator, measure);
  const auto add = [&](std::string_view name, const std::vector<double>& cycles) {
    results::ComparedLife found =
        compared(std::string(name), line_words(name), integrator, cycles, own);
    if (std::isfinite(found.ratio) && std::abs(found.ratio - 1.0) > same_life) {
      out.push_back(std::move(found));
    }
  };
  const std::vector<base::Vector> loads = loads_of_steps(model);
  if (!measure.spectrum()) {
    const auto r = ratio_of(loads[model.growth->kmin.index()], loads[model.growth->kmax.index()]);
    if (r) {
      for (growth::SolvedStation& station : stations) {
        for (growth::TipStation& tip : station.tips) {
          tip.K_min = *r * tip.K_max;
        }
      }
      add(results::life_of_scaled_K, cycles_of(integrator, stations, measure));
    }
    return out;
  }
  std::vector<results::LoadPathResult> paths; // [station]
  for (const results::CrackLengthResult& increment : run.increments) {
    if (const results::LoadPathResult* path = growth_load_path(model, increment)) {
      paths.push_back(*path);
    }
  }
  if (paths.size() < stations.size() || tips > 1) {
    return out;
  }
  const std::size_t path = model.spectra[*model.growth->spectrum].path;
  const base::Vector& from = loads[model.load_paths[path].from.index()];
  const base::Vector& to = loads[model.load_paths[path].to.index()];
  if (from.norm() == 0.0 && to.norm() > 0.0) {
    if (const auto scaled = on_line(paths, stations, measure, true)) {
      add(results::life_of_scaled_K, cycles_of(integrator, *scaled, measure));
    }
  }
  if (const auto line = on_line(paths, stations, measure, false)) {
    add(results::life_by_line_of_K, cycles_of(integrator, *line, measure));
  }
  return out;
}

std::vector<results::ComparedLife>
lives_by_other_interactions(const model::Model& model, const growth::GrowthIntegrator& integrator,
                            const GrowthRateEvaluator& measure) {
  std::vector<results::ComparedLife> out;
  const std::vector<growth::SolvedStation>& stations = integrator.growth_state().stations;
  const auto& rules = model.growth->interactions;
  if (stations.size() < 2 || rules.size() < 2) {
    return out;
  }
  const std::vector<double> own = own_cycles(integrator, measure);
  for (std::size_t i = 1; i < rules.size(); ++i) {
    const life::LoadInteraction other = make_load_interaction(model, rules[i]);
    const std::vector<double> passes =
        PassCounter(*measure.spectrum(), other).passes_at(stations, life_curve_places(integrator));
    const std::string name = rules[i] ? model.interactions[*rules[i]].name : "NONE";
    out.push_back(compared(name, "interaction " + name, integrator, passes, own));
  }
  return out;
}

} // namespace spricka::analysis
