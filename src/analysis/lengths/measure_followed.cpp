// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/lengths/growth_measure.hpp"
#include "crack/k_layout.hpp"
#include "life/rainflow.hpp"
#include "model/model.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

/// Growth by K of loads that were followed one after another, as friction asks for.
namespace spricka::analysis {

namespace {

constexpr double worst_mismatch = 1e-6; // of K against that of recovered displacements

base::Vec2 of_tip(const base::Vector& K, std::size_t tip) {
  return crack::KLayout(tip + 1, 2).point_entries(K, tip);
}

// K1 and K2 where K1 is largest in a pass.
base::Vec2 largest(const LoadPassResult& pass, std::size_t tip) {
  base::Vec2 best(-std::numeric_limits<double>::infinity(), 0.0);
  const auto look = [&](const WayOfK& way) {
    for (const base::Vector& all : way) {
      const base::Vec2 K = of_tip(all, tip);
      best = K[0] > best[0] ? K : best;
    }
  };
  look(pass.way);
  for (const auto& [way, count] : pass.cycles) {
    look(way);
  }
  return best;
}

} // namespace

void GrowthRateEvaluator::of_pass(const LoadPassResult& pass, const KOfLaw& K,
                                  growth::TipStation& found) const {
  double low = std::numeric_limits<double>::infinity();
  double high = -low;
  found.rate = 0.0;
  const auto count = [&](const WayOfK& way, double times) {
    std::vector<double> along;
    along.reserve(way.size());
    for (const base::Vector& all : way) {
      const double k = along.emplace_back(K(all));
      low = std::min(low, k);
      high = std::max(high, k);
    }
    // Counted on K itself: with friction it is no function of the load.
    for (const life::LoadCycle& cycle : life::rainflow(along, true)) {
      if (cycle.high > 0.0 && cycle.high > cycle.low) {
        found.rate += times * cycle.count * law_.growth_rate(cycle.high, cycle.low);
      }
    }
  };
  count(pass.way, 1.0);
  for (const auto& [way, times] : pass.cycles) {
    count(way, times);
  }
  found.K_min = low;
  found.K_max = std::max(0.0, high);
}

void GrowthRateEvaluator::of_loads(const LoadHistoryResult& loads, const KOfLaw& K,
                                   growth::TipStation& found) const {
  growth::TipStation first; // of the first cycle or pass
  if (spectrum_) {
    of_pass(loads.last, K, found);
    of_pass(loads.first, K, first);
  } else {
    found.K_max = std::max(0.0, K(loads.last.marks[loads.grow_at]));
    found.K_min = K(loads.last.marks[loads.smallest]);
    found.rate = found.K_max > found.K_min ? law_.growth_rate(found.K_max, found.K_min) : 0.0;
    first.K_max = std::max(0.0, K(loads.first.marks[loads.grow_at]));
    first.K_min = K(loads.first.marks[loads.smallest]);
  }
  found.first_max = first.K_max;
  found.first_min = first.K_min;
  found.passes = loads.passes;
  found.change = loads.change;
}

void GrowthRateEvaluator::look_at(const LoadHistoryResult& loads, double a) {
  if (!(loads.change <= repeats_to)) {
    warnings_.insert(
        {"W507",
         fmt::format(
             "K did not repeat itself within {} passes of the loads: at a = {:.6g} it still "
             "changes by {:.1e} of the largest K from one to the next",
             loads.passes, a, loads.change)});
  }
  if (!(loads.mismatch <= worst_mismatch)) {
    warnings_.insert({"W507", fmt::format("K of the loads that were followed differs from K of the "
                                          "displacements by {:.1e} of the largest",
                                          loads.mismatch)});
  }
  if (model_.growth->corrected) {
    warnings_.insert(
        {"W456", "CORRECT=YES, but with friction K has no error bar: K is as computed"});
  }
}

bool GrowthRateEvaluator::by_history(const SolvedCrackState& at, const std::string& name,
                                     bool straight, growth::TipStation& found) {
  const LoadHistoryResult& loads = *at.followed;
  const std::vector<results::TipResult>& tips = at.increment.steps[largest_load_step(model_)].tips;
  const auto own = std::ranges::find(tips, name, &results::TipResult::name);
  if (own == tips.end() || own->two_materials) {
    return no_rate(
        fmt::format("{} cannot grow, as it has no K: its tip lies between two materials", name));
  }
  const auto tip = static_cast<std::size_t>(own - tips.begin());
  // The turn of the last pass holds for the first as well: both are told of one kink.
  const base::Vec2 K =
      spectrum_ ? largest(loads.last, tip) : of_tip(loads.last.marks[loads.grow_at], tip);
  const base::Vec2 part = turn(K, straight, found);
  of_loads(
      loads, [&](const base::Vector& all) { return part.dot(of_tip(all, tip)); }, found);
  if (!spectrum_) {
    look_at(name, K, found.K_min > found.K_max);
  }
  look_at(loads, at.increment.a);
  return !std::isnan(found.rate) || no_rate({});
}

bool GrowthRateEvaluator::by_front_history(const LoadHistoryResult& loads, const std::string& name,
                                           double a, const KOfLaw& K1, growth::TipStation& found) {
  of_loads(loads, K1, found);
  // Only faces that touch have K1 = 0 to the last bit.
  if (continues_below_closing(model_) && found.K_min == 0.0) {
    warn_of_closing(name, a);
  }
  if (!spectrum_) {
    note_order(name, found.K_min > found.K_max && found.K_min > 0.0);
  }
  look_at(loads, a);
  return !std::isnan(found.rate) ||
         no_rate(fmt::format("the growth of a pass of the loads is not a number at {}", name));
}

} // namespace spricka::analysis
