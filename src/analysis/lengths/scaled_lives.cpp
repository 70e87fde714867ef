// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/lengths/scaled_lives.hpp"

#include "analysis/lengths/growth_records.hpp"
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
      const base::PiecewiseLinear line({0.0, top}, {K0}, {((*K1)(top)-K0) / top});
      tip.rate = tip.extent_rate_ratio * measure.spectrum()->growth_per_pass(
                                             measure.law(), line, growth::place_of_tip(tip, tip.a));
    }
    if (!(stations[i].growth_rate() > 0.0)) {
      return std::nullopt;
    }
  }
  return stations;
}

std::optional<results::ScaledKLife> life(const std::string& name,
                                         const growth::GrowthIntegrator& integrator,
                                         const growth::GrowthTrajectory& other) {
  const std::vector<growth::SolvedStation>& stations = integrator.growth_state().stations;
  const double end = integrator.growth_end() ? integrator.growth_end()->s : stations.back().s;
  const growth::GrowthTrajectory between = integrator.trajectory();
  results::ScaledKLife out;
  out.name = name;
  out.curve = life_curve(integrator, other, 1);
  out.ratio = out.curve.back().cycles / between.cycles(stations.front().s, end);
  const bool tells = std::isfinite(out.ratio) && std::abs(out.ratio - 1.0) > same_life;
  return tells ? std::optional(std::move(out)) : std::nullopt;
}

} // namespace

std::vector<results::ScaledKLife>
lives_by_proportional_K(const model::Model& model, const results::RunResult& run,
                        const growth::GrowthIntegrator& integrator,
                        const GrowthRateEvaluator& measure) {
  std::vector<results::ScaledKLife> out;
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
  const auto add = [&](std::optional<results::ScaledKLife> found) {
    if (found) {
      out.push_back(std::move(*found));
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
      const growth::GrowthRateFunction law = [&](double K_max, double K_min,
                                                 const model::PlaceOnCrack& place) {
        return measure.law().growth_rate(K_max, K_min, place);
      };
      add(life("scaled", integrator, growth::GrowthTrajectory(stations, law, 4)));
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
      add(life("scaled", integrator, growth::GrowthTrajectory(*scaled, {}, 4)));
    }
  }
  if (const auto line = on_line(paths, stations, measure, false)) {
    add(life("line", integrator, growth::GrowthTrajectory(*line, {}, 4)));
  }
  return out;
}

} // namespace spricka::analysis
