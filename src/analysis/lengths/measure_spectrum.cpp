// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/lengths/growth_measure.hpp"
#include "analysis/lengths/path_correction.hpp"
#include "model/model.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

/// Growth by K on the load path of a spectrum.
namespace spricka::analysis {

namespace {

// Of a front at the ends of the path that has none.
void warn_of_bars_on_path(const model::Model& model, const results::CrackLengthResult& increment,
                          const std::string& name, GrowthWarnings& warnings) {
  const model::SpectrumDefinition& card = model.spectra[*model.growth->spectrum];
  const model::LoadPathDefinition& path = model.load_paths[card.path];
  for (const base::StepId step : {path.from, path.to}) {
    for (const results::FrontResult& end : increment.steps[step.index()].fronts) {
      // In space look_at_front() has told of the largest load.
      if (end.is_tip() ? end.name == name : step == path.from) {
        warnings.warn_of_missing_error_bar(end);
      }
    }
  }
}

} // namespace

double locate_K1_maximum(const base::PiecewiseLinear& K1, double low, double high) {
  double best = K1(high) >= K1(low) ? high : low;
  for (const double t : K1.knots()) {
    best = t > low && t < high && K1(t) > K1(best) ? t : best;
  }
  return best;
}

base::PiecewiseLinear GrowthRateEvaluator::on_path(const SolvedCrackState& at,
                                                   const results::LoadPathFront& front,
                                                   const PlaceOnFront& place,
                                                   const base::Vec2& part) {
  base::PiecewiseLinear K = combined_K_over_path(front, place, part);
  // Without overlap anywhere both ways to K are one.
  if (!(at.free || faces_touch_on_path(front.points[place.from].smooth[0])) ||
      !continues_K_below_closing(model_)) {
    return K;
  }
  const std::size_t path = model_.spectra[*model_.growth->spectrum].path;
  const results::LoadPathFront* free =
      at.free && path < at.free->paths.size()
          ? results::find_front(at.free->paths[path], front.front_without_points.name)
          : nullptr;
  std::optional<base::PiecewiseLinear> below;
  if (free != nullptr) {
    below = continue_K_with_overlapping_faces(K, combined_K_over_path(*free, place, part),
                                              spectrum_->highest_load());
  }
  if (!below) {
    warnings_.warn_of_closing_faces(front.front_without_points.name, front.front_without_points.a);
  }
  return below ? std::move(*below) : std::move(K);
}

growth::GrowthRateFunction GrowthRateEvaluator::rates_between_stations() const {
  if (!spectrum_) {
    return [this](double K_max, double K_min, const model::PlaceOnCrack& place) {
      return law_.growth_rate(K_max, K_min, place);
    };
  }
  if (interaction_ || !few_cycles_) {
    return {};
  }
  return growth::GrowthRateFunction::of_passes(
      [this](const base::PiecewiseLinear& K, const model::PlaceOnCrack& place) {
        return growth_per_pass(K, place);
      });
}

base::PiecewiseLinear GrowthRateEvaluator::at_loads_of_spectrum(base::PiecewiseLinear K) const {
  if (loads_.size() < 2 || loads_.size() >= K.knots().size() ||
      spectrum_->requires_counting_on_K(K)) {
    return K;
  }
  std::vector<double> values;
  for (const double t : loads_) {
    values.push_back(K(t));
  }
  return base::PiecewiseLinear::through(loads_, std::move(values));
}

double GrowthRateEvaluator::growth_per_pass(const base::PiecewiseLinear& K,
                                            const model::PlaceOnCrack& place) const {
  return interaction_
             ? interaction_->growth_of_settled_pass(spectrum_->cycles_in_order_as_K(K), place)
             : spectrum_->growth_per_pass(law_, K, place);
}

bool GrowthRateEvaluator::by_spectrum(const SolvedCrackState& at, const GrowingPlace& to,
                                      growth::TipStation& found) {
  const model::SpectrumDefinition& card = model_.spectra[*model_.growth->spectrum];
  const results::LoadPathResult& path = *at.path;
  const PlaceOnFront place = nearest_place(path.fronts, to.front, to.aim);
  if (!place.found() || path.t.empty() || path.t.back() < spectrum_->highest_load()) {
    return no_rate(
        fmt::format("spectrum {}: there is no K up to t = {:.6g}, load path {} ends before: {}",
                    card.name, spectrum_->highest_load(), path.name, path.stopped));
  }
  warn_of_bars_on_path(model_, at.increment, to.front, warnings_);
  const results::LoadPathFront& front = path.fronts[place.front];
  const bool tip = front.points.size() == 1;
  if (tip && !front.front_without_points.invalid_reason.empty()) {
    warnings_.add({"W508", fmt::format("{}: K on load path {} is in doubt: {}", to.name, path.name,
                                       front.front_without_points.invalid_reason)});
  }
  // The way on is that at the largest load; K of the whole path is then taken at the tip of that
  // kink (growth.8).
  const base::PiecewiseLinear K1 = combined_K_over_path(front, place, {1.0, 0.0});
  const base::PiecewiseLinear K2 = combined_K_over_path(front, place, {0.0, 1.0});
  const double peak = locate_K1_maximum(K1, spectrum_->lowest_load(), spectrum_->highest_load());
  const base::Vec2 part =
      kink_tip_and_get_K_factors(model_, {K1(peak), K2(peak)}, to.straight, found);
  const base::PiecewiseLinear K = on_path(at, front, place, part);
  const auto [low, high] = spectrum_->extreme_K(K);
  found.K_min = low;
  found.K_max = std::max(0.0, high);
  life::LawUseCounter use(law_, model_.growth->data);
  found.rate = spectrum_->growth_per_pass(law_, K, to.on_crack, &use);
  found.law_use = use.use();
  if (interaction_) {
    found.rate = growth_per_pass(K, to.on_crack);
  }
  if (interaction_ || few_cycles_) {
    found.K_over_path = at_loads_of_spectrum(K);
  }
  if (law_.has_constant_threshold()) {
    for (const life::LoadCycle& cycle : spectrum_->cycles_as_K(K)) {
      look_at_threshold(to, cycle.high, cycle.low);
    }
  }
  counted_on_K_ = counted_on_K_ || spectrum_->requires_counting_on_K(K);
  if (std::isnan(found.rate)) {
    return no_rate(fmt::format("spectrum {}: the growth of a pass is not a number {}", card.name,
                               tip ? fmt::format("at a = {:.6g}", front.front_without_points.a)
                                   : fmt::format("on crack {}", to.front)));
  }
  return true;
}

} // namespace spricka::analysis
