// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/lengths/growth_measure.hpp"
#include "life/law_use_counter.hpp"
#include "life/ordered_cycles.hpp"
#include "model/model.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

#include <fmt/format.h>

/// Growth by K of loads that were followed one after another, as friction asks for.
namespace spricka::analysis {

namespace {

// K1 and K2 where K1 is largest in a pass, of the place that `K_of` takes them of.
template <class KOf> base::Vec2 largest(const LoadPassResult& pass, const KOf& K_of) {
  base::Vec2 best(-std::numeric_limits<double>::infinity(), 0.0);
  const auto look = [&](const KSequence& way) {
    for (const base::Vector& all : way) {
      const base::Vec2 K = K_of(all);
      best = K[0] > best[0] ? K : best;
    }
  };
  look(pass.way);
  for (const auto& [way, count] : pass.cycles) {
    look(way);
  }
  return best;
}

// The K that the law is given, out of those of all tips [crack::KLayout].
using KOfLaw = std::function<double(const base::Vector&)>;

/// The growth of cycles of K, in their order, at a place of a crack.
using GrowthOfCycles = std::function<double(const std::vector<life::LoadCycle>&)>;

// Rate and extremes of K in a pass of the spectrum that was followed.
void measure_pass(const GrowthOfCycles& growth, model::CycleCounting counting,
                  const LoadPassResult& pass, const KOfLaw& K, growth::TipStation& found) {
  double low = std::numeric_limits<double>::infinity();
  double high = -low;
  const auto count = [&](const KSequence& way, double times) {
    std::vector<double> along;
    along.reserve(way.size());
    for (const base::Vector& all : way) {
      const double k = along.emplace_back(K(all));
      low = std::min(low, k);
      high = std::max(high, k);
    }
    // Counted on K itself: with friction it is no function of the load.
    for (life::LoadCycle cycle : life::order_cycles(along, counting)) {
      cycle.count *= times;
      found.cycles_of_K.push_back(cycle);
    }
  };
  count(pass.way, 1.0);
  for (const auto& [way, times] : pass.cycles) {
    count(way, times);
  }
  found.rate = growth(found.cycles_of_K);
  found.K_min = low;
  found.K_max = std::max(0.0, high);
}

model::LawUse use_of_law(const life::GrowthRateLaw& law, const model::GrowthLawData& data,
                         const std::vector<life::LoadCycle>& cycles,
                         const model::PlaceOnCrack& place) {
  life::LawUseCounter use(law, data);
  for (const life::LoadCycle& cycle : cycles) {
    if (cycle.high > 0.0 && cycle.high > cycle.low) {
      use.add(cycle.high, cycle.low, cycle.count, law.growth_rate(cycle.high, cycle.low, place));
    }
  }
  return use.use();
}

// Rate and extremes of the loads that were followed, of the first cycle and of those that repeat
// themselves.
void measure_loads(const GrowthOfCycles& growth, const model::SpectrumDefinition* spectrum,
                   const LoadHistoryKResult& loads, const KOfLaw& K, growth::TipStation& found) {
  growth::TipStation first; // of the first cycle or pass
  if (spectrum != nullptr) {
    measure_pass(growth, spectrum->counting, loads.last, K, found);
    measure_pass(growth, spectrum->counting, loads.first, K, first);
  } else {
    found.K_max = std::max(0.0, K(loads.last.marks[loads.grow_at]));
    found.K_min = K(loads.last.marks[loads.smallest]);
    found.cycles_of_K = {{found.K_min, found.K_max, 1.0}};
    found.rate = growth(found.cycles_of_K);
    first.K_max = std::max(0.0, K(loads.first.marks[loads.grow_at]));
    first.K_min = K(loads.first.marks[loads.smallest]);
  }
  found.first_max = first.K_max;
  found.first_min = first.K_min;
  found.passes = loads.passes;
  found.change = loads.change;
}

} // namespace

bool GrowthRateEvaluator::by_history(const SolvedCrackState& at, const GrowingPlace& to,
                                     const PlaceOnFront& place, growth::TipStation& found) {
  const LoadHistoryKResult& loads = *at.followed;
  const results::LoadStepResult& step = at.increment.steps[largest_load_step(model_)];
  const results::FrontResult& front = step.fronts[place.front];
  const auto K_of = [K1 = make_K_interpolator(step, place, 1),
                     K2 = make_K_interpolator(step, place, 2)](const base::Vector& all) {
    return base::Vec2(K1(all), K2(all));
  };
  const base::Vec2 grown = K_of(loads.last.marks[loads.grow_at]);
  // The turn of the last pass holds for the first as well: both are told of one kink. In space the
  // front turns by K of the steps.
  const base::Vec2 K = !front.is_tip() ? intensity(front, place)
                       : spectrum_     ? largest(loads.last, K_of)
                                       : grown;
  const base::Vec2 part = kink_tip_and_get_K_factors(model_, K, to.straight, found);
  const GrowthOfCycles growth = [&](const std::vector<life::LoadCycle>& cycles) {
    double sum = 0.0;
    for (const life::LoadCycle& cycle : cycles) {
      if (cycle.high > 0.0 && cycle.high > cycle.low) {
        look_at_threshold(to, cycle.high, cycle.low);
        sum += cycle.count * law_.growth_rate(cycle.high, cycle.low, to.on_crack);
      }
    }
    return interaction_ ? interaction_->growth_of_settled_pass(cycles, to.on_crack) : sum;
  };
  measure_loads(
      growth, spectrum_ ? &model_.spectra[*model_.growth->spectrum] : nullptr, loads,
      [&](const base::Vector& all) { return part.dot(K_of(all)); }, found);
  found.law_use = use_of_law(law_, model_.growth->data, found.cycles_of_K, to.on_crack);
  if (!interaction_) {
    found.cycles_of_K.clear(); // a sum needs no order
  }
  if (front.is_tip()) {
    if (!spectrum_) {
      note_order(to.name, found.K_min > found.K_max);
      warnings_.warn_of_K2(to.name, K);
    }
    warnings_.warn_of_load_history(loads, at.increment.a);
  } else {
    found.K2_max = grown[1];
    // Only faces that touch have K1 = 0 to the last bit.
    if (continues_K_below_closing(model_) && found.K_min == 0.0) {
      warnings_.warn_of_closing_faces(to.name, front.a);
    }
    if (!spectrum_) {
      note_order(to.name, found.K_min > found.K_max && found.K_min > 0.0);
    }
    warnings_.warn_of_load_history(loads, front.a);
  }
  return !std::isnan(found.rate) ||
         no_rate(fmt::format("the growth of a pass of the loads is not a number at {}", to.name));
}

} // namespace spricka::analysis
