// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/lengths/growth_measure.hpp"

#include "analysis/lengths/pass_counter.hpp"
#include "analysis/lengths/path_correction.hpp"
#include "crack/direction.hpp"
#include "growth/net_section.hpp"
#include "model/model.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <set>
#include <utility>

#include <fmt/format.h>

namespace spricka::analysis {

namespace {

/// Rates of a pass are computed between stations for as many different cycles; of more the rate is
/// smooth, as each of them is a small part of it.
constexpr std::size_t most_cycles_between_stations = 1000;
/// K1 that the mesh cannot tell from 0 where K2 rules.
constexpr double much_less_than_K2 = 1e-3;

std::optional<life::CountedSpectrum> spectrum_of(const model::Model& model) {
  if (!model.growth->spectrum) {
    return std::nullopt;
  }
  return life::CountedSpectrum::from_definition(model.spectra[*model.growth->spectrum]);
}

// Whether a tip with this K is open at the largest load: a closed one grows nowhere. K1 = 0 stands
// for faces that touch; K1 < 0 but for round-off for such that overlap.
bool opens(const base::Vec2& K) {
  return K[0] != 0.0 && K[0] > -much_less_than_K2 * std::abs(K[1]);
}

GrowingPlace growing_place(const growth::CrackGeometry& cracks,
                           const std::vector<growth::TrackedTip>& growing, std::size_t i) {
  GrowingPlace to{.name = growing[i].name, .front = growing[i].name};
  if (cracks.solids.empty()) {
    to.straight = cracks.lines[growing[i].line].symmetric_half;
  } else { // the crack that its own has become a part of
    to.front = cracks.solid_crack_at_tip(i).name;
    to.aim = cracks.aims[i];
  }
  return to;
}

// The plastic part of a tip in the plane whose edge ahead is found.
void add_plastic_ratio(const model::Model& model, const growth::PlaneBoundaryAhead& around,
                       const SolvedCrackState& at, const growth::TrackedTip& tip,
                       growth::TipStation& found) {
  for (const mesh::CrackFront& front : at.fronts) {
    if (!front.is_tip() || !model.growth->flow_stress) {
      continue;
    }
    const mesh::CrackLine& line = at.cracks.lines[tip.line];
    // The second tip, or the only one, stands at the last point of its line.
    const bool second = front.number == 2 || !line.embedded;
    if (front.crack != line.crack || second == tip.at_first) {
      continue;
    }
    const growth::TipGrowthDirection heading{front.tip_point().x, front.tip_point().growth};
    // Without an edge ahead there is no ligament that could yield.
    if (const auto edge = around.edge_ahead(line, heading)) {
      found.plastic = growth::plastic_load_ratio(
          model, at.increment.mesh,
          {front.tip_point().node, front.tip_point().x, front.tip_point().growth, edge->distance},
          at.increment.steps[largest_load_step(model)].u, *model.growth->flow_stress);
    }
  }
}

} // namespace

life::GrowthRateLaw growth_law(const model::CrackGrowthSettings& growth) {
  return {growth.law, growth.constants};
}

GrowthRateEvaluator::GrowthRateEvaluator(const model::Model& model)
    : model_(model), law_(growth_law(*model.growth)), spectrum_(spectrum_of(model)),
      around_(model.mesh), warnings_(*model.growth) {
  if (spectrum_) {
    std::set<double> loads;
    const std::vector<life::LoadCycle> cycles = spectrum_->cycles();
    for (const life::LoadCycle& cycle : cycles) {
      loads.insert({cycle.low, cycle.high});
    }
    loads_.assign(loads.begin(), loads.end());
    few_cycles_ = cycles.size() <= most_cycles_between_stations;
  }
  if (!model.growth->interactions.empty()) {
    interaction_.emplace(make_load_interaction(model, model.growth->interactions.front()));
  }
}

bool GrowthRateEvaluator::no_rate(std::string why) {
  trouble_ = base::OperationFailure{.kind = base::ProgramOutcome::not_solvable,
                                    .why = std::move(why),
                                    .span = model_.growth->span};
  return false;
}

// The step whose loads stand for the largest: of a spectrum the one at the end of its path.
std::size_t largest_load_step(const model::Model& model) {
  const std::optional<std::size_t>& spectrum = model.growth->spectrum;
  return spectrum ? model.load_paths[model.spectra[*spectrum].path].to.index()
                  : model.growth->kmax.index();
}

const results::LoadPathResult* growth_load_path(const model::Model& model,
                                                const results::CrackLengthResult& increment) {
  return model.growth->spectrum && !increment.paths.empty()
             ? &increment.paths[model.spectra[*model.growth->spectrum].path]
             : nullptr;
}

base::Vec2 kink_tip_and_get_K_factors(const model::Model& model, const base::Vec2& K, bool straight,
                                      growth::TipStation& found) {
  found.K2_max = K[1];
  // On a line of symmetry a crack cannot turn; a closed tip has no direction to go.
  if (straight || !opens(K) || model.growth->direction == model::GrowthDirection::path) {
    return {1.0, 0.0};
  }
  const crack::KinkCriterion criterion = model.growth->direction == model::GrowthDirection::hoop
                                             ? crack::KinkCriterion::hoop
                                             : crack::KinkCriterion::k2_zero;
  found.turn = crack::kink_angle(criterion, K[0], K[1]);
  return crack::kinked_K1_factors(criterion, found.turn);
}

std::optional<std::vector<growth::TipStation>>
GrowthRateEvaluator::evaluate_tip_rates(const SolvedCrackState& at,
                                        const std::vector<growth::TrackedTip>& growing,
                                        const std::vector<double>& extents) {
  std::vector<growth::TipStation> found(growing.size());
  upside_down_ = true;
  if (at.followed && !at.followed->none.empty()) {
    warnings_.add(
        {"W456", fmt::format("with friction K depends on the load history, but the loads were "
                             "not repeated: {}; K is that of the steps as they were run once",
                             at.followed->none)});
  }
  for (std::size_t i = 0; i < growing.size(); ++i) {
    GrowingPlace to = growing_place(at.cracks, growing, i);
    to.on_crack.a = extents[i];
    if (!evaluate_place(at, to, found[i])) {
      return std::nullopt;
    }
    add_plastic_ratio(model_, around_, at, growing[i], found[i]);
  }
  return found;
}

bool GrowthRateEvaluator::evaluate_place(const SolvedCrackState& at, GrowingPlace to,
                                         growth::TipStation& found) {
  const std::vector<results::FrontResult>& fronts =
      at.increment.steps[largest_load_step(model_)].fronts;
  const PlaceOnFront place = nearest_place(fronts, to.front, to.aim);
  if (!place.found()) {
    return no_rate(fmt::format("crack {} has no front to grow from", to.front));
  }
  if (fronts[place.front].two_materials) {
    return no_rate(
        fmt::format("{} cannot grow, as it has no K: its tip lies between two materials", to.name));
  }
  if (!fronts[place.front].is_tip()) {
    look_at_front(at, to, place, found);
    const std::optional<double>& own = model_.growth->constants.k_part_through;
    if (own && is_part_through(fronts[place.front])) {
      to.on_crack.toughness = own;
      found.toughness = *own;
    }
  }
  if (at.followed && at.followed->none.empty()) {
    return by_history(at, to, place, found);
  }
  return spectrum_ ? by_spectrum(at, to, found) : by_steps(at, to, place, found);
}

void GrowthRateEvaluator::look_at_front(const SolvedCrackState& at, const GrowingPlace& to,
                                        const PlaceOnFront& place, growth::TipStation& found) {
  const std::vector<results::FrontResult>& fronts =
      at.increment.steps[largest_load_step(model_)].fronts;
  const results::FrontResult& front = fronts[place.front];
  const base::Vec3 x = point_on_front_curve(front, place);
  found.x = x.x();
  found.y = x.y();
  found.z = x.z();
  if (!at.plastic.empty()) {
    assert(at.plastic.size() == fronts.size());
    found.plastic = at.plastic[place.front];
  }
  warnings_.warn_of_missing_error_bar(front.name, front.missing_bar_reason);
  const base::Vec3 K = interpolate_smooth_K(front, place);
  warnings_.warn_of_invalid_result(front, K[0]);
  warnings_.note_neglected_shear_K(to.front, K);
}

base::Vec2 GrowthRateEvaluator::intensity(const results::FrontResult& front,
                                          const PlaceOnFront& place) {
  if (!front.is_tip()) {
    return interpolate_smooth_K(front, place).head<2>();
  }
  warnings_.warn_of_missing_error_bar(front);
  return {front.single_point().K1, front.single_point().K2};
}

void GrowthRateEvaluator::note_order(const std::string& name, bool upside_down) {
  upside_down_ = upside_down_ && upside_down;
  if (upside_down) {
    warnings_.add({"W456", fmt::format("{}: K at KMIN is larger than at KMAX", name)});
  }
}

void GrowthRateEvaluator::look_at_threshold(const GrowingPlace& to, double K_max, double K_min) {
  if (K_max > 0.0 && law_.is_held_by_constant_threshold(K_max, K_min)) {
    warnings_.warn_of_constant_threshold(to.front, to.on_crack.a, K_max, K_min);
  }
}

double GrowthRateEvaluator::at_smallest(const SolvedCrackState& at, const GrowingPlace& to,
                                        const base::Vec2& part, const results::FrontResult& front,
                                        const PlaceOnFront& place) {
  const double K = part.dot(intensity(front, place));
  if (!continues_K_below_closing(model_)) {
    return K;
  }
  const results::FrontResult* free =
      find_tip_overlap_result(at.free, model_.growth->kmin.index(), front.name);
  if (free == nullptr) {
    if (front.points[place.from].closed) {
      warnings_.warn_of_closing_faces(to.name, front.a);
    }
    return K;
  }
  const double below = part.dot(base::Vec2(free->single_point().K1, free->single_point().K2));
  // Above zero nothing overlaps, and K with contact is right.
  return below < 0.0 ? below : K;
}

bool GrowthRateEvaluator::by_steps(const SolvedCrackState& at, const GrowingPlace& to,
                                   const PlaceOnFront& place, growth::TipStation& found) {
  const results::FrontResult& high =
      at.increment.steps[model_.growth->kmax.index()].fronts[place.front];
  const results::LoadStepResult& smallest = at.increment.steps[model_.growth->kmin.index()];
  const PlaceOnFront there = nearest_place(smallest.fronts, to.front, to.aim);
  if (!there.found()) {
    return no_rate(fmt::format("crack {} has no front to grow from", to.front));
  }
  const results::FrontResult& low = smallest.fronts[there.front];
  if (high.is_tip()) {
    warnings_.warn_of_invalid_result(high, high.single_point().K1);
  }
  const base::Vec2 K = intensity(high, place);
  const base::Vec2 part = kink_tip_and_get_K_factors(model_, K, to.straight, found);
  found.K_max = std::max(0.0, part.dot(K));
  found.K_min = at_smallest(at, to, part, low, there);
  found.rate =
      found.K_max > found.K_min ? law_.growth_rate(found.K_max, found.K_min, to.on_crack) : 0.0;
  life::LawUseCounter use(law_, model_.growth->data);
  use.add(found.K_max, found.K_min, 1.0, found.rate);
  found.law_use = use.use();
  look_at_threshold(to, found.K_max, found.K_min);
  if (high.is_tip()) {
    note_order(to.name,
               low.single_point().K1 > high.single_point().K1 && low.single_point().K1 > 0.0);
    warnings_.warn_of_K2(to.name, K);
  } else {
    note_order(to.name, found.K_min > K[0] && found.K_min > 0.0);
  }
  return true;
}

} // namespace spricka::analysis
