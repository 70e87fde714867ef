// SPDX-License-Identifier: GPL-3.0-or-later
#include "life/spectrum.hpp"

#include "base/turning_points.hpp"
#include "life/no_value.hpp"
#include "life/ordered_cycles.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <utility>

namespace spricka::life {

namespace {

// The knots where K1 turns or is level on one side, ascending.
std::vector<std::size_t> turns(const base::PiecewiseLinear& K1) {
  std::vector<std::size_t> found;
  for (std::size_t k = 1; k < K1.segment_count(); ++k) {
    if (!(K1.slope_before(k) * K1.slope_after(k) > 0.0)) {
      found.push_back(k);
    }
  }
  return found;
}

// K along the way from load to load, with its turns in between.
class KSequence {
public:
  explicit KSequence(const base::PiecewiseLinear& K1) : K1_(K1) {
    for (const std::size_t k : turns(K1)) {
      t_.push_back(K1.knots()[k]);
      K_.push_back(K1.value_at_knot(k));
    }
  }

  std::vector<double> operator()(const std::vector<double>& loads) const {
    std::vector<double> way;
    for (std::size_t i = 0; i < loads.size(); ++i) {
      if (i > 0) {
        between(loads[i - 1], loads[i], way);
      }
      way.push_back(K1_(loads[i]));
    }
    return way;
  }

private:
  // The turns strictly between two loads, in the order in which the load passes them.
  void between(double from, double to, std::vector<double>& way) const {
    const auto [low, high] = std::minmax(from, to);
    const auto first = std::upper_bound(t_.begin(), t_.end(), low) - t_.begin();
    const auto last = std::lower_bound(t_.begin(), t_.end(), high) - t_.begin();
    if (first >= last) {
      return;
    }
    if (from < to) {
      way.insert(way.end(), K_.begin() + first, K_.begin() + last);
    } else {
      way.insert(way.end(), K_.rend() - last, K_.rend() - first);
    }
  }

  const base::PiecewiseLinear& K1_;
  std::vector<double> t_, K_; ///< turns
};

// K at ascending loads that lie within the knots: one walk.
std::vector<double> values_at(const base::PiecewiseLinear& K1, const std::vector<double>& loads) {
  std::vector<double> values;
  values.reserve(loads.size());
  const std::vector<double>& knots = K1.knots();
  std::size_t s = 0;
  double value = K1.value_at_knot(0);
  for (const double t : loads) {
    while (s + 1 < K1.segment_count() && knots[s + 1] < t) {
      value = K1.value_at_knot(++s);
    }
    values.push_back(value + (t - knots[s]) * K1.slope(s));
  }
  return values;
}

} // namespace

CountedSpectrum::CountedSpectrum(const std::vector<LoadCycle>& counted) {
  // every load with its place: 2 i is the low one of cycle i, 2 i + 1 the high one
  std::vector<std::pair<double, std::uint32_t>> loads;
  loads.reserve(2 * counted.size());
  for (const LoadCycle& cycle : counted) {
    loads.emplace_back(cycle.low, static_cast<std::uint32_t>(loads.size()));
    loads.emplace_back(cycle.high, static_cast<std::uint32_t>(loads.size()));
  }
  std::sort(loads.begin(), loads.end());
  std::vector<std::uint32_t> level(loads.size());
  for (const auto& [load, place] : loads) {
    if (levels_.empty() || load > levels_.back()) {
      levels_.push_back(load);
    }
    level[place] = static_cast<std::uint32_t>(levels_.size() - 1);
  }
  cycles_.reserve(counted.size());
  for (std::size_t i = 0; i < counted.size(); ++i) {
    cycles_.push_back({.low = level[2 * i], .high = level[2 * i + 1], .count = counted[i].count});
  }
  // By count as well: the sums of equal cycles then have the same bits in whatever order they came.
  std::sort(cycles_.begin(), cycles_.end(), [](const LoadLevelCycle& a, const LoadLevelCycle& b) {
    return a.low != b.low ? a.low < b.low : a.high != b.high ? a.high < b.high : a.count < b.count;
  });
  std::size_t kept = 0;
  for (std::size_t i = 1; i < cycles_.size(); ++i) {
    if (cycles_[i].low == cycles_[kept].low && cycles_[i].high == cycles_[kept].high) {
      cycles_[kept].count += cycles_[i].count;
    } else {
      cycles_[++kept] = cycles_[i];
    }
  }
  cycles_.resize(std::min(cycles_.size(), kept + 1));
}

CountedSpectrum CountedSpectrum::from_cycles(std::vector<LoadCycle> cycles) {
  assert(!cycles.empty());
  for (LoadCycle& cycle : cycles) {
    if (cycle.high < cycle.low) {
      std::swap(cycle.low, cycle.high);
    }
  }
  return CountedSpectrum(cycles);
}

CountedSpectrum::CountedSpectrum(std::vector<LoadCycle> counted, std::vector<double> history,
                                 bool repeated)
    : CountedSpectrum(counted.empty() // a constant load
                          ? std::vector<LoadCycle>{{history.front(), history.front(), 0.0}}
                          : std::move(counted)) {
  // The way from the end of a pass to its start may pass turns of K, too.
  if (repeated) {
    history.push_back(history.front());
  }
  history_ = base::turning_points(history);
  repeated_ = repeated;
}

CountedSpectrum CountedSpectrum::from_sequence(std::vector<double> history, bool repeated) {
  assert(!history.empty());
  std::vector<LoadCycle> counted = count_rainflow_cycles(history, repeated);
  return {std::move(counted), std::move(history), repeated};
}

CountedSpectrum CountedSpectrum::from_pairs(std::vector<double> history) {
  assert(!history.empty());
  std::vector<LoadCycle> counted = pair_valleys_with_peaks(history);
  CountedSpectrum spectrum(std::move(counted), std::move(history), true);
  spectrum.counting_ = model::CycleCounting::pairs;
  return spectrum;
}

CountedSpectrum CountedSpectrum::from_definition(const model::SpectrumDefinition& spectrum) {
  std::vector<LoadCycle> in_order = order_cycles(spectrum);
  CountedSpectrum counted = !spectrum.sequence ? from_cycles(in_order)
                            : spectrum.counting == model::CycleCounting::pairs
                                ? from_pairs(spectrum.turning_points)
                                : from_sequence(spectrum.turning_points);
  counted.in_order_ = std::move(in_order);
  return counted;
}

std::vector<LoadCycle>
CountedSpectrum::cycles_in_order_as_K(const base::PiecewiseLinear& K1) const {
  const bool on_K = requires_counting_on_K(K1);
  const KSequence way(K1);
  if (on_K && !history_.empty()) {
    return order_cycles(way(history_), counting_);
  }
  std::vector<LoadCycle> all;
  for (const LoadCycle& cycle : in_order_) {
    if (on_K) {
      // A block cycle is a closed way: up through the turns of K and down again.
      for (LoadCycle part : order_cycles(way({cycle.low, cycle.high, cycle.low}), counting_)) {
        part.count *= cycle.count;
        all.push_back(part);
      }
    } else {
      const auto [low, high] = std::minmax({K1(cycle.low), K1(cycle.high)});
      all.push_back({low, high, cycle.count}); // K may fall while the load rises
    }
  }
  return all;
}

double CountedSpectrum::cycles_per_pass() const {
  double sum = 0.0;
  for (const LoadLevelCycle& cycle : cycles_) {
    sum += cycle.count;
  }
  return sum;
}

std::vector<LoadCycle> CountedSpectrum::cycles() const {
  std::vector<LoadCycle> all;
  all.reserve(cycles_.size());
  for (const LoadLevelCycle& cycle : cycles_) {
    all.push_back({.low = levels_[cycle.low], .high = levels_[cycle.high], .count = cycle.count});
  }
  return all;
}

bool CountedSpectrum::within(const base::PiecewiseLinear& K1) const {
  return !K1.empty() && lowest_load() >= K1.knots().front() && highest_load() <= K1.knots().back();
}

bool CountedSpectrum::requires_counting_on_K(const base::PiecewiseLinear& K1) const {
  bool rises = false;
  bool falls = false;
  for (std::size_t s = 0; s < K1.segment_count(); ++s) {
    // Only what the loads pass through: K may turn elsewhere on the path. Level pieces reverse
    // nothing.
    if (K1.knots()[s] < highest_load() && K1.knots()[s + 1] > lowest_load()) {
      rises = rises || K1.slope(s) > 0.0;
      falls = falls || K1.slope(s) < 0.0;
    }
  }
  return rises && falls;
}

std::pair<double, double> CountedSpectrum::extreme_K(const base::PiecewiseLinear& K1) const {
  if (!within(K1)) {
    return {no_value, no_value};
  }
  // K is piecewise linear: extremes are at its turns, or at the ends of the loads.
  const std::vector<double> way = KSequence(K1)({lowest_load(), highest_load()});
  const auto [low, high] = std::minmax_element(way.begin(), way.end());
  return {*low, *high};
}

std::vector<LoadCycle> CountedSpectrum::cycles_of_K(const base::PiecewiseLinear& K1) const {
  const KSequence way(K1);
  if (!history_.empty()) {
    return counting_ == model::CycleCounting::pairs
               ? pair_valleys_with_peaks(way(history_))
               : count_rainflow_cycles(way(history_), repeated_);
  }
  std::vector<LoadCycle> all;
  for (const LoadLevelCycle& cycle : cycles_) {
    const double low = levels_[cycle.low];
    const double high = levels_[cycle.high];
    // A block cycle is a closed way: up through the turns of K and down again.
    for (LoadCycle part : count_rainflow_cycles(way({low, high, low}), true)) {
      part.count *= cycle.count;
      all.push_back(part);
    }
  }
  return all;
}

template <class Visit>
void CountedSpectrum::visit_cycles_as_K(const base::PiecewiseLinear& K1, const Visit& visit) const {
  if (requires_counting_on_K(K1)) {
    for (const LoadCycle& cycle : cycles_of_K(K1)) {
      visit(cycle.low, cycle.high, cycle.count);
    }
    return;
  }
  const std::vector<double> K = values_at(K1, levels_);
  for (const LoadLevelCycle& cycle : cycles_) {
    // K may fall while the load rises.
    const auto [low, high] = std::minmax(K[cycle.low], K[cycle.high]);
    visit(low, high, cycle.count);
  }
}

double CountedSpectrum::growth_per_pass(const GrowthRateLaw& law, const base::PiecewiseLinear& K1,
                                        const model::PlaceOnCrack& place,
                                        LawUseCounter* use) const {
  if (!within(K1)) {
    return no_value;
  }
  double sum = 0.0;
  visit_cycles_as_K(K1, [&](double low, double high, double count) {
    const double rate = law.growth_rate(high, low, place);
    sum += count * rate;
    if (use != nullptr) {
      use->add(high, low, count, rate);
    }
  });
  return sum;
}

std::vector<double> CountedSpectrum::growth_by_cycle(const GrowthRateLaw& law,
                                                     const base::PiecewiseLinear& K1,
                                                     const model::PlaceOnCrack& place) const {
  std::vector<double> grown;
  if (within(K1) && !requires_counting_on_K(K1)) {
    grown.reserve(cycles_.size());
    visit_cycles_as_K(K1, [&](double low, double high, double count) {
      grown.push_back(count * law.growth_rate(high, low, place));
    });
  }
  return grown;
}

std::vector<LoadCycle> CountedSpectrum::cycles_as_K(const base::PiecewiseLinear& K1) const {
  std::vector<LoadCycle> all;
  if (within(K1)) {
    visit_cycles_as_K(K1, [&](double low, double high, double count) {
      all.push_back({low, high, count});
    });
  }
  return all;
}

} // namespace spricka::life
