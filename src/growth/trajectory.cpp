// SPDX-License-Identifier: GPL-3.0-or-later
#include "growth/trajectory.hpp"

#include "shape/quadrature.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>
#include <utility>

namespace spricka::growth {

namespace {

/// Parts of an interval between stations, each with five Gauss points: a law near its toughness or
/// its threshold bends more than K does.
constexpr int parts = 24;
constexpr int degree = 9;

// Stations about an interval with no passage between them: from the first to before the second.
std::pair<std::size_t, std::size_t> smooth_about(const std::vector<SolvedStation>& stations,
                                                 std::size_t interval) {
  const std::size_t n = stations.size();
  if (interval + 1 < n && stations[interval + 1].breakthroughs > 0) {
    return {interval, interval + 2};
  }
  std::size_t low = interval;
  std::size_t high = std::min(interval + 2, n);
  for (; low > 0 && stations[low].breakthroughs == 0; --low) {
  }
  for (; high < n && stations[high].breakthroughs == 0; ++high) {
  }
  return {low, high};
}

} // namespace

double tip_path_curvature(const TipStation& before, const TipStation& here) {
  return here.a > before.a ? std::remainder(here.heading - before.heading, 2.0 * std::numbers::pi) /
                                 (here.a - before.a)
                           : 0.0;
}

double SolvedStation::growth_rate() const {
  double sum = 0.0;
  for (const TipStation& tip : tips) {
    sum += tip.rate;
  }
  return sum;
}

StationRange nearest_stations(const std::vector<SolvedStation>& stations, std::size_t interval,
                              std::size_t points, std::size_t low, std::size_t high) {
  const auto [from, to] = smooth_about(stations, interval);
  low = std::max(low, from);
  high = std::min(high, to);
  StationRange out;
  out.points = std::min(points, high - low);
  // As many on either side of the interval as there are; near an end the nearest that exist.
  const std::size_t before = (out.points - 1) / 2;
  out.first = std::min(std::max(interval, low + before) - before, high - out.points);
  return out;
}

ExtentOverInterval::ExtentOverInterval(const SolvedStation& left, const SolvedStation& right,
                                       std::size_t tip)
    : s_(left.s), h_(right.s - left.s), a_(left.tips[tip].a),
      difference_(right.tips[tip].a - left.tips[tip].a) {
  // Where rates give no slope that of the chord is taken.
  const auto share = [&](const SolvedStation& station) {
    const double all = station.growth_rate();
    return all > 0.0 && std::isfinite(all) ? station.tips[tip].rate / all : difference_ / h_;
  };
  // Hermite: the shares of all tips add up to 1, so that their arms add up to s
  left_ = share(left) * h_ - difference_;
  right_ = difference_ - share(right) * h_;
}

double extent_rate_ratio(const SolvedStation& left, const SolvedStation& right, std::size_t tip,
                         double s) {
  const double before = left.tips[tip].extent_rate_ratio;
  const double part = right.s > left.s ? (s - left.s) / (right.s - left.s) : 0.0;
  return before + part * (right.tips[tip].extent_rate_ratio - before);
}

GrowthTrajectory::GrowthTrajectory(const std::vector<SolvedStation>& stations,
                                   GrowthRateFunction law, std::size_t points)
    : stations_(stations), law_(std::move(law)), points_(std::min(points, stations.size())) {
  for (const SolvedStation& station : stations_) {
    extents_differ_ =
        extents_differ_ || std::ranges::any_of(station.tips, [](const TipStation& tip) {
          return tip.extent_rate_ratio != 1.0;
        });
  }
  paths_ = std::ranges::all_of(stations_, [](const SolvedStation& station) {
    return std::ranges::none_of(station.tips,
                                [](const TipStation& tip) { return tip.K_over_path.empty(); });
  });
  for (const SolvedStation& station : stations_) {
    ln_s_.push_back(std::log(station.s));
  }
  ln_K_max_.resize(stations_.front().tips.size());
  for (std::size_t tip = 0; tip < ln_K_max_.size(); ++tip) {
    // Closed cracks have no logarithm: then K itself is interpolated, at all s alike.
    if (std::ranges::all_of(stations_, [&](const SolvedStation& station) {
          return station.tips[tip].K_max > 0.0;
        })) {
      for (const SolvedStation& station : stations_) {
        ln_K_max_[tip].push_back(std::log(station.tips[tip].K_max));
      }
    }
  }
}

std::size_t GrowthTrajectory::interval(double s) const {
  std::size_t i = 0;
  while (i + 2 < stations_.size() && s > stations_[i + 1].s) {
    ++i;
  }
  return i;
}

GrowthTrajectory::StationWeights GrowthTrajectory::weights_at(std::size_t interval, double s,
                                                              std::size_t low,
                                                              std::size_t high) const {
  StationWeights out{nearest_stations(stations_, interval, points_, low, high), {}};
  const double x = std::log(s);
  for (std::size_t i = 0; i < out.points; ++i) {
    double weight = 1.0;
    for (std::size_t k = 0; k < out.points; ++k) {
      if (k != i) {
        const double other = ln_s_[out.first + k];
        weight *= (x - other) / (ln_s_[out.first + i] - other);
      }
    }
    out.weight[i] = weight;
  }
  return out;
}

template <class Value>
double GrowthTrajectory::interpolate(const StationWeights& weights, const Value& value) const {
  double sum = 0.0;
  for (std::size_t i = 0; i < weights.points; ++i) {
    sum += weights.weight[i] * value(weights.first + i);
  }
  return sum;
}

double GrowthTrajectory::K_max(std::size_t tip, const StationWeights& weights) const {
  const std::vector<double>& ln_K = ln_K_max_[tip];
  return ln_K.empty()
             ? interpolate(weights, [&](std::size_t k) { return stations_[k].tips[tip].K_max; })
             : std::exp(interpolate(weights, [&](std::size_t k) { return ln_K[k]; }));
}

double GrowthTrajectory::K_max(std::size_t tip, double s) const {
  return K_max(tip, weights_at(interval(s), s, 0, stations_.size()));
}

double GrowthTrajectory::plastic_load_ratio(std::size_t tip, double s) const {
  return interpolate(weights_at(interval(s), s, 0, stations_.size()),
                     [&](std::size_t k) { return stations_[k].tips[tip].plastic; });
}

double GrowthTrajectory::tip_rate(std::size_t tip, std::size_t i, double s,
                                  const StationWeights& weights) const {
  const SolvedStation& right = stations_[std::min(i + 1, stations_.size() - 1)];
  const auto of_arm = [&](double rate) {
    return extents_differ_ ? extent_rate_ratio(stations_[i], right, tip, s) * rate : rate;
  };
  if (law_.of_cycle) {
    const double K = K_max(tip, weights);
    // K_min may be below 0 and has no logarithm: its ratio to K_max is interpolated.
    const double R = interpolate(weights, [&](std::size_t k) {
      const TipStation& t = stations_[k].tips[tip];
      return t.K_max > 0.0 ? t.K_min / t.K_max : 0.0;
    });
    return of_arm(
        law_.of_cycle(K, R * K, place_of_tip(stations_[i].tips[tip], crack_extent(tip, s))));
  }
  if (law_.of_pass && paths_) {
    return of_arm(law_.of_pass(K_over_path(tip, weights),
                               place_of_tip(stations_[i].tips[tip], crack_extent(tip, s))));
  }
  return interpolated_rate(tip, i, s, weights);
}

// Each load by its part of K_max, as K_min in the rate of a cycle.
base::PiecewiseLinear GrowthTrajectory::K_over_path(std::size_t tip,
                                                    const StationWeights& weights) const {
  const auto path = [&](std::size_t k) -> const base::PiecewiseLinear& {
    return stations_[k].tips[tip].K_over_path;
  };
  // Mostly the loads of a spectrum, the same at all stations.
  std::vector<double> t = path(weights.first).knots();
  bool alike = true;
  for (std::size_t k = 1; k < weights.points && alike; ++k) {
    alike = path(weights.first + k).knots() == t;
  }
  if (!alike) {
    std::set<double> knots;
    for (std::size_t k = 0; k < weights.points; ++k) {
      const std::vector<double>& here = path(weights.first + k).knots();
      knots.insert(here.begin(), here.end());
    }
    t.assign(knots.begin(), knots.end());
  }
  const bool by_part = !ln_K_max_[tip].empty();
  const double largest = by_part ? K_max(tip, weights) : 1.0;
  std::vector<double> K;
  K.reserve(t.size());
  for (std::size_t j = 0; j < t.size(); ++j) {
    K.push_back(largest * interpolate(weights, [&](std::size_t k) {
                  const double here = alike ? path(k).value_at_knot(j) : path(k)(t[j]);
                  return here / (by_part ? stations_[k].tips[tip].K_max : 1.0);
                }));
  }
  return base::PiecewiseLinear::through(std::move(t), std::move(K));
}

double GrowthTrajectory::interpolated_rate(std::size_t tip, std::size_t i, double s,
                                           const StationWeights& weights) const {
  // a spectrum's rates, as far as they are numbers: none at a threshold, no bound at the toughness
  const auto usual = [&](std::size_t k) {
    const double rate = stations_[k].tips[tip].rate;
    return rate > 0.0 && std::isfinite(rate);
  };
  if (!usual(i)) {
    return stations_[i].tips[tip].rate;
  }
  std::size_t low = i;
  std::size_t high = i + 1;
  for (; low > 0 && usual(low - 1); --low) {
  }
  for (; high < stations_.size() && usual(high); ++high) {
  }
  // A rate that falls to zero at the next station has no logarithm there: a straight line.
  if (high == i + 1 && high < stations_.size() && stations_[high].tips[tip].rate == 0.0) {
    const double here = stations_[i].tips[tip].rate;
    return here * (stations_[high].s - s) / (stations_[high].s - stations_[i].s);
  }
  const bool all = low == 0 && high == stations_.size();
  return std::exp(interpolate(all ? weights : weights_at(i, s, low, high), [&](std::size_t k) {
    return std::log(stations_[k].tips[tip].rate);
  }));
}

double GrowthTrajectory::growth_rate(double s) const {
  const std::size_t i = interval(s);
  const StationWeights weights = weights_at(i, s, 0, stations_.size());
  double sum = 0.0;
  for (std::size_t tip = 0; tip < stations_.front().tips.size(); ++tip) {
    sum += tip_rate(tip, i, s, weights);
  }
  return sum;
}

double GrowthTrajectory::crack_extent(std::size_t tip, double s) const {
  if (stations_.size() == 1) {
    return stations_[0].tips[tip].a;
  }
  const std::size_t i = interval(s);
  return ExtentOverInterval(stations_[i], stations_[i + 1], tip)(s);
}

double GrowthTrajectory::gauss(double s0, double s1) const {
  const double half = 0.5 * (s1 - s0);
  double sum = 0.0;
  for (const auto& [xi, weight] : shape::line_rule(degree)) {
    sum += weight * half / growth_rate(0.5 * (s0 + s1) + xi[0] * half);
  }
  return sum;
}

double GrowthTrajectory::cycles(double s0, double s1) const {
  double sum = 0.0;
  for (std::size_t i = 0; i + 1 < stations_.size(); ++i) {
    const double from = std::max(s0, stations_[i].s);
    const double to = std::min(s1, stations_[i + 1].s);
    // Never across a station: the polynomials change there.
    for (int k = 0; k < parts && from < to; ++k) {
      sum += gauss(from + (to - from) * k / parts, from + (to - from) * (k + 1) / parts);
    }
  }
  return sum;
}

std::optional<double> GrowthTrajectory::extent_after_cycles(double s0, double cycles) const {
  const double last = stations_.back().s;
  if (this->cycles(s0, last) < cycles) {
    return std::nullopt;
  }
  return find_first_crossing([&](double s) { return this->cycles(s0, s) - cycles; }, s0, last);
}

std::optional<double> find_first_crossing(const std::function<double(double)>& value, double s0,
                                          double s1) {
  constexpr int looks = 16;
  double low = s0;
  for (int k = 1; k <= looks; ++k) {
    double high = s0 + (s1 - s0) * k / looks;
    // Looked at from the front: bisection between the ends might find a later root.
    if (value(high) < 0.0) {
      low = high;
      continue;
    }
    while (high - low > 1e-12 * s1) {
      const double middle = 0.5 * (low + high);
      if (middle <= low || middle >= high) {
        break;
      }
      (value(middle) < 0.0 ? low : high) = middle;
    }
    return high;
  }
  return std::nullopt;
}

} // namespace spricka::growth
