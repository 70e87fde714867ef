// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/lengths/growth_measure.hpp"

#include "analysis/lengths/path_correction.hpp"
#include "analysis/scene/tip_name.hpp"
#include "crack/direction.hpp"
#include "growth/net_section.hpp"
#include "model/model.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

namespace spricka::analysis {

namespace {

/// K2 beyond this part of K1 on a given path is worth a word.
constexpr double much_K2 = 0.25;
/// K1 that the mesh cannot tell from 0 where K2 rules.
constexpr double much_less_than_K2 = 1e-3;

life::RateEquation kind_of(model::CrackGrowthLaw law) {
  switch (law) {
  case model::CrackGrowthLaw::walker:
    return life::RateEquation::walker;
  case model::CrackGrowthLaw::forman:
    return life::RateEquation::forman;
  case model::CrackGrowthLaw::nasgro:
    return life::RateEquation::nasgro;
  case model::CrackGrowthLaw::table:
    return life::RateEquation::table;
  case model::CrackGrowthLaw::increment:
  case model::CrackGrowthLaw::paris:
    break;
  }
  return life::RateEquation::paris;
}

std::optional<life::CountedSpectrum> spectrum_of(const model::Model& model) {
  if (!model.growth->spectrum) {
    return std::nullopt;
  }
  const model::SpectrumDefinition& card = model.spectra[*model.growth->spectrum];
  if (card.sequence) {
    return life::CountedSpectrum::from_sequence(card.turning_points);
  }
  std::vector<life::LoadCycle> cycles;
  for (const auto& [low, high, count] : card.cycles) {
    cycles.push_back({.low = low, .high = high, .count = count});
  }
  return life::CountedSpectrum::from_cycles(std::move(cycles));
}

// first * K1 + second * K2 on the path.
base::PiecewiseLinear combined(const results::LoadPathTip& tip, const base::Vec2& part) {
  // Straight on: the path's own K1, to the last bit.
  if (part[1] == 0.0 && part[0] == 1.0) {
    return tip.K1;
  }
  std::vector<double> value;
  std::vector<double> slope;
  for (std::size_t i = 0; i < tip.K1.segments(); ++i) {
    value.push_back(part[0] * tip.K1.at_knot(i) + part[1] * tip.K2.at_knot(i));
    slope.push_back(part[0] * tip.K1.slope(i) + part[1] * tip.K2.slope(i));
  }
  return {tip.K1.knots(), std::move(value), std::move(slope)};
}

} // namespace

double locate_maximum(const base::PiecewiseLinear& K1, double low, double high) {
  double best = K1(high) >= K1(low) ? high : low;
  for (const double t : K1.knots()) {
    best = t > low && t < high && K1(t) > K1(best) ? t : best;
  }
  return best;
}

life::GrowthRateLaw growth_law(const model::CrackGrowthSettings& growth) {
  const model::GrowthLawConstants& c = growth.constants;
  return {kind_of(growth.law),
          {.C = c.C,
           .m = c.m,
           .p = c.p,
           .q = c.q,
           .alpha = c.alpha,
           .stress_ratio = c.stress_ratio,
           .threshold = c.threshold,
           .k_c = c.k_c,
           .k_unit = c.k_unit,
           .a_unit = c.a_unit,
           .delta_k = c.delta_k,
           .growth = c.growth}};
}

GrowthRateEvaluator::GrowthRateEvaluator(const model::Model& model)
    : model_(model), law_(growth_law(*model.growth)), spectrum_(spectrum_of(model)),
      around_(model.mesh) {}

void GrowthRateEvaluator::warn_of_mesh(const std::string& code, const std::string& text,
                                       std::size_t station) {
  const bool known = std::ranges::any_of(
      warnings_, [&](const results::Warning& warning) { return warning.code == code; });
  if (!known) {
    warnings_.insert({code, fmt::format("{} (station {})", text, station)});
  }
}

bool GrowthRateEvaluator::no_rate(std::string why) {
  trouble_ = base::OperationFailure{
      .kind = base::Outcome::not_solvable, .why = std::move(why), .span = model_.growth->span};
  return false;
}

// The step whose loads stand for the largest: of a spectrum the one at the end of its path.
std::size_t largest_load_step(const model::Model& model) {
  const std::optional<std::size_t>& spectrum = model.growth->spectrum;
  return spectrum ? model.load_paths[model.spectra[*spectrum].path].to.index()
                  : model.growth->kmax.index();
}

std::optional<results::LoadPathResult> growth_load_path(const model::Model& model,
                                                        const results::Increment& increment) {
  if (!model.growth->spectrum || increment.paths.empty()) {
    return std::nullopt;
  }
  const std::size_t number = model.spectra[*model.growth->spectrum].path;
  const model::LoadPathDefinition& card = model.load_paths[number];
  const results::LoadPathResult& path = increment.paths[number];
  return model.growth->corrected ? corrected_path(path, increment.steps[card.from.index()],
                                                  increment.steps[card.to.index()])
                                 : path;
}

std::optional<std::vector<growth::TipStation>>
GrowthRateEvaluator::evaluate_tips(const SolvedCrackState& at,
                                   const std::vector<growth::TrackedTip>& growing) {
  std::vector<growth::TipStation> found(growing.size());
  upside_down_ = true;
  const bool history = at.followed && at.followed->none.empty();
  if (at.followed && !history) {
    warnings_.insert(
        {"W456", fmt::format("with friction K depends on the load history, but the loads were "
                             "not repeated: {}; K is that of the steps as they were run once",
                             at.followed->none)});
  }
  for (std::size_t i = 0; i < growing.size(); ++i) {
    if (!at.cracks.solids.empty()) {
      growth::TrackedTip tip = growing[i];
      tip.line = at.cracks.fronts[i]; // the crack that its own has become a part of
      if (!by_front(at, tip, at.cracks.aims[i], found[i])) {
        return std::nullopt;
      }
      continue;
    }
    const mesh::CrackLine& line = at.cracks.lines[growing[i].line];
    const std::string& name = growing[i].name;
    const bool straight = line.symmetric_half;
    const bool good = history     ? by_history(at, name, straight, found[i])
                      : spectrum_ ? by_spectrum(at, name, straight, found[i])
                                  : by_steps(at, name, straight, found[i]);
    if (!good) {
      return std::nullopt;
    }
    for (const mesh::CrackFront& front : at.tips) {
      // The second tip, or the only one, stands at the last point of its line.
      const bool second = front.number == 2 || !line.embedded;
      if (model_.growth->flow_stress && front.crack == line.crack &&
          second != growing[i].at_first) {
        plastic(at.increment, front, line, found[i]);
      }
    }
  }
  return found;
}

void GrowthRateEvaluator::warn_of_no_bar(const std::string& name, const std::string& why) {
  if (!why.empty()) {
    warnings_.insert(
        {"W456", fmt::format("CORRECT=YES, but {} has no error bar everywhere ({}): there K is "
                             "as computed",
                             name, why)});
  }
}

bool GrowthRateEvaluator::has_bar(const results::TipResult& tip) {
  if (!tip.closed) {
    warn_of_no_bar(tip.name, tip.no_bar);
  }
  return tip.no_bar.empty();
}

base::Vec2 GrowthRateEvaluator::intensity(const results::TipResult& tip) {
  return model_.growth->corrected && has_bar(tip) ? base::Vec2(tip.bar[0].best, tip.bar[1].best)
                                                  : base::Vec2(tip.K1, tip.K2);
}

// K1 = 0 stands for faces that touch; K1 < 0 but for round-off for such that overlap.
bool GrowthRateEvaluator::opens(const base::Vec2& K) {
  return K[0] != 0.0 && K[0] > -much_less_than_K2 * std::abs(K[1]);
}

base::Vec2 GrowthRateEvaluator::turn(const base::Vec2& K, bool straight,
                                     growth::TipStation& found) const {
  found.K2_max = K[1];
  // On a line of symmetry a crack cannot turn; a closed tip has no direction to go.
  if (straight || !opens(K) || model_.growth->direction == model::GrowthDirection::path) {
    return {1.0, 0.0};
  }
  const crack::KinkCriterion criterion = model_.growth->direction == model::GrowthDirection::hoop
                                             ? crack::KinkCriterion::hoop
                                             : crack::KinkCriterion::k2_zero;
  found.turn = crack::kink_angle(criterion, K[0], K[1]);
  return crack::kinked_K1_factors(criterion, found.turn);
}

void GrowthRateEvaluator::note_order(const std::string& name, bool upside_down) {
  upside_down_ = upside_down_ && upside_down;
  if (upside_down) {
    warnings_.insert({"W456", fmt::format("{}: K at KMIN is larger than at KMAX", name)});
  }
}

void GrowthRateEvaluator::look_at(const std::string& name, const base::Vec2& K, bool upside_down) {
  note_order(name, upside_down);
  if (model_.growth->direction == model::GrowthDirection::path && K[0] > 0.0 &&
      std::abs(K[1]) > much_K2 * K[0]) {
    warnings_.insert(
        {"W456", fmt::format("{} grows along its path although K2 is {:.2f} of K1; the law is "
                             "given K1 alone",
                             name, K[1] / K[0])});
  }
}

void GrowthRateEvaluator::warn_of_closing(const std::string& name, double a) {
  warnings_.insert(
      {"W456", fmt::format("{}: at a = {:.6g} its faces close and there is no solution with "
                           "faces that overlap: K_min is 0 there, though the law knows R < 0; "
                           "the life may come out too long",
                           name, a)});
}

double GrowthRateEvaluator::at_smallest(const SolvedCrackState& at, const results::TipResult& tip,
                                        const base::Vec2& part) {
  const double K = part.dot(intensity(tip));
  if (!continues_below_closing(model_)) {
    return K;
  }
  const results::TipResult* free = tip_with_overlap(at.free, model_.growth->kmin.index(), tip.name);
  if (free == nullptr) {
    if (tip.closed) {
      warn_of_closing(tip.name, tip.a);
    }
    return K;
  }
  const double below = part.dot(base::Vec2(free->K1, free->K2));
  // Above zero nothing overlaps, and K with contact is right.
  return below < 0.0 ? below : K;
}

bool GrowthRateEvaluator::by_steps(const SolvedCrackState& at, const std::string& name,
                                   bool straight, growth::TipStation& found) {
  const results::Increment& increment = at.increment;
  const results::TipResult* high =
      results::find_tip(increment.steps[model_.growth->kmax.index()], name);
  const results::TipResult* low =
      results::find_tip(increment.steps[model_.growth->kmin.index()], name);
  if (high == nullptr || low == nullptr || high->two_materials) {
    return no_rate(
        fmt::format("{} cannot grow, as it has no K: its tip lies between two materials", name));
  }
  if (!high->invalid_reason.empty() && high->K1 > 0.0) {
    warnings_.insert(
        {"W508", fmt::format("{}: K at KMAX is in doubt: {}", name, high->invalid_reason)});
  }
  const base::Vec2 K = intensity(*high);
  const base::Vec2 part = turn(K, straight, found);
  found.K_max = std::max(0.0, part.dot(K));
  found.K_min = at_smallest(at, *low, part);
  found.rate = found.K_max > found.K_min ? law_.growth_rate(found.K_max, found.K_min) : 0.0;
  look_at(name, K, low->K1 > high->K1 && low->K1 > 0.0);
  return true;
}

base::PiecewiseLinear GrowthRateEvaluator::on_path(const SolvedCrackState& at,
                                                   const results::LoadPathTip& tip,
                                                   const base::Vec2& part) {
  base::PiecewiseLinear K = combined(tip, part);
  // Without overlap anywhere both ways to K are one.
  if (!(at.free || faces_touch(tip.K1)) || !continues_below_closing(model_)) {
    return K;
  }
  const std::size_t path = model_.spectra[*model_.growth->spectrum].path;
  const results::LoadPathTip* free = at.free && path < at.free->paths.size()
                                         ? results::find_tip(at.free->paths[path], tip.name)
                                         : nullptr;
  std::optional<base::PiecewiseLinear> below;
  if (free != nullptr) {
    below = continue_below_zero(K, combined(*free, part), spectrum_->highest());
  }
  if (!below) {
    warn_of_closing(tip.name, tip.a);
  }
  return below ? std::move(*below) : std::move(K);
}

bool GrowthRateEvaluator::by_spectrum(const SolvedCrackState& at, const std::string& name,
                                      bool straight, growth::TipStation& found) {
  const results::Increment& increment = at.increment;
  const model::SpectrumDefinition& card = model_.spectra[*model_.growth->spectrum];
  const results::LoadPathResult& path = *at.path;
  const results::TipResult* at_end =
      results::find_tip(increment.steps[largest_load_step(model_)], name);
  const results::LoadPathTip* tip = results::find_tip(path, name);
  if (at_end != nullptr && at_end->two_materials) {
    return no_rate(
        fmt::format("{} cannot grow, as it has no K: its tip lies between two materials", name));
  }
  if (tip == nullptr || path.t.empty() || path.t.back() < spectrum_->highest()) {
    return no_rate(
        fmt::format("spectrum {}: there is no K up to t = {:.6g}, load path {} ends before: {}",
                    card.name, spectrum_->highest(), path.name, path.stopped));
  }
  if (model_.growth->corrected) {
    for (const base::StepId step :
         {model_.load_paths[card.path].from, model_.load_paths[card.path].to}) {
      if (const auto* end = results::find_tip(increment.steps[step.index()], name)) {
        has_bar(*end);
      }
    }
  }
  if (!tip->invalid_reason.empty()) {
    warnings_.insert({"W508", fmt::format("{}: K on load path {} is in doubt: {}", name, path.name,
                                          tip->invalid_reason)});
  }
  // The way on is that at the largest load; K of the whole path is then taken at the tip of that
  // kink (growth.8).
  const double peak = locate_maximum(tip->K1, spectrum_->lowest(), spectrum_->highest());
  const base::Vec2 part = turn({tip->K1(peak), tip->K2(peak)}, straight, found);
  const base::PiecewiseLinear K = on_path(at, *tip, part);
  const auto [low, high] = spectrum_->extreme_K(K);
  found.K_min = low;
  found.K_max = std::max(0.0, high);
  found.rate = spectrum_->growth_per_pass(law_, K);
  counted_on_K_ = counted_on_K_ || spectrum_->counts_on_K(K);
  if (std::isnan(found.rate)) {
    return no_rate(fmt::format("spectrum {}: the growth of a pass is not a number at a = {:.6g}",
                               card.name, tip->a));
  }
  return true;
}

void GrowthRateEvaluator::plastic(const results::Increment& increment,
                                  const mesh::CrackFront& front, const mesh::CrackLine& line,
                                  growth::TipStation& found) const {
  const growth::TipGrowthDirection heading{front.tip_point().x, front.tip_point().growth};
  // Without an edge ahead there is no ligament that could yield.
  if (const auto edge = around_.edge_ahead(line, heading)) {
    found.plastic = growth::plastic_load_ratio(
        model_, increment.mesh,
        {front.tip_point().node, front.tip_point().x, front.tip_point().growth, edge->distance},
        increment.steps[largest_load_step(model_)].u, *model_.growth->flow_stress);
  }
}

} // namespace spricka::analysis
