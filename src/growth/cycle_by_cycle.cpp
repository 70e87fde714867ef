// SPDX-License-Identifier: GPL-3.0-or-later
#include "growth/cycle_by_cycle.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <limits>
#include <set>

namespace spricka::growth {

using life::LoadCycle;
using life::LoadInteraction;
using life::OverloadMemory;

namespace {

constexpr std::size_t most_points = 4; // of a polynomial, as between stations elsewhere
constexpr double infinite = std::numeric_limits<double>::infinity();

/// A polynomial of degree 3 at most: coefficients, the constant first.
using CubicCoefficients = std::array<double, most_points>;

double value_of(const CubicCoefficients& c, double u) {
  return c[0] + u * (c[1] + u * (c[2] + u * c[3]));
}

// Lagrange's polynomials over the knots u.
std::vector<CubicCoefficients> lagrange_basis(const std::vector<double>& u) {
  std::vector<CubicCoefficients> basis;
  for (std::size_t i = 0; i < u.size(); ++i) {
    CubicCoefficients product{1.0};
    for (std::size_t k = 0; k < u.size(); ++k) {
      if (k == i) {
        continue;
      }
      const double by = 1.0 / (u[i] - u[k]);
      for (std::size_t d = most_points; d-- > 0;) {
        product[d] = by * ((d > 0 ? product[d - 1] : 0.0) - u[k] * product[d]);
      }
    }
    basis.push_back(product);
  }
  return basis;
}

} // namespace

/// K of all loads at one tip between two stations: the largest of them by its logarithm, the others
/// by what they are of it.
class CycleByCycleGrowth::KOfLoads {
public:
  KOfLoads(const CycleByCycleGrowth& whole, std::size_t tip) : whole_(whole), tip_(tip) {}

  void enter(std::size_t interval) {
    left_ = &whole_.stations_[interval];
    right_ = &whole_.stations_[interval + 1];
    extent_.emplace(*left_, *right_, tip_);
    ln_s_ = std::log(left_->s);
    const StationRange range =
        nearest_stations(whole_.stations_, interval, most_points, 0, whole_.stations_.size());
    std::vector<double> u;
    paths_.clear();
    largest_at_.clear();
    turns_ = false;
    for (std::size_t k = range.first; k < range.first + range.points; ++k) {
      const base::PiecewiseLinear& path = whole_.stations_[k].tips[tip_].K_over_path;
      paths_.push_back(&path);
      largest_at_.push_back(whole_.spectrum_.extreme_K(path).second);
      turns_ = turns_ || whole_.spectrum_.requires_counting_on_K(path);
      u.push_back(std::log(whole_.stations_[k].s) - ln_s_);
    }
    basis_ = lagrange_basis(u);
    // Closed cracks have no logarithm: then K itself is interpolated.
    logarithmic_ = std::ranges::all_of(largest_at_, [](double k) { return k > 0.0; });
    largest_ = 1.0;
  }

  /// To be called before the rest, for all that is asked at s.
  void go_to(double s) {
    s_ = s;
    const double u = std::log(s) - ln_s_;
    double top = 0.0;
    for (std::size_t i = 0; i < basis_.size(); ++i) {
      weight_[i] = value_of(basis_[i], u);
      top += logarithmic_ ? weight_[i] * std::log(largest_at_[i]) : 0.0;
    }
    if (logarithmic_) {
      largest_ = std::exp(top);
      for (std::size_t i = 0; i < basis_.size(); ++i) {
        weight_[i] *= largest_ / largest_at_[i];
      }
    }
  }
  /// At a place of the load path.
  [[nodiscard]] double K(double t) const {
    double sum = 0.0;
    for (std::size_t i = 0; i < paths_.size(); ++i) {
      sum += weight_[i] * (*paths_[i])(t);
    }
    return sum;
  }
  [[nodiscard]] double scale() const { return largest_; }
  [[nodiscard]] bool turns() const { return turns_; }
  [[nodiscard]] model::PlaceOnCrack place() const {
    return place_of_tip(left_->tips[tip_], (*extent_)(s_));
  }
  [[nodiscard]] double rate_ratio() const { return extent_rate_ratio(*left_, *right_, tip_, s_); }
  /// K over the load path.
  [[nodiscard]] base::PiecewiseLinear path() const {
    std::set<double> knots;
    for (const base::PiecewiseLinear* path : paths_) {
      knots.insert(path->knots().begin(), path->knots().end());
    }
    std::vector<double> values;
    values.reserve(knots.size());
    for (const double t : knots) {
      values.push_back(K(t));
    }
    return base::PiecewiseLinear::through({knots.begin(), knots.end()}, std::move(values));
  }

private:
  const CycleByCycleGrowth& whole_;
  std::size_t tip_;
  const SolvedStation* left_ = nullptr;
  const SolvedStation* right_ = nullptr;
  std::optional<ExtentOverInterval> extent_;
  double ln_s_ = 0.0;
  std::vector<const base::PiecewiseLinear*> paths_; ///< [station]
  std::vector<double> largest_at_;                  ///< [station]
  std::vector<CubicCoefficients> basis_;            ///< [station]
  CubicCoefficients weight_{};                      ///< [station] what its K counts at s
  bool logarithmic_ = true;
  bool turns_ = false; ///< K within the loads, at one of the stations
  double s_ = 0.0, largest_ = 1.0;
};

/// One growth. visit(s, s_next, passes, passes_next) is told of each cycle; false: enough.
class CycleByCycleGrowth::Run {
public:
  Run(const CycleByCycleGrowth& whole, const LoadInteraction& interaction)
      : whole_(whole), interaction_(interaction), tips_(whole.stations_.front().tips.size()),
        memory_(tips_), s_(whole.stations_.front().s) {
    for (std::size_t tip = 0; tip < tips_; ++tip) {
      tip_K_.emplace_back(whole_, tip);
    }
    enter_interval();
  }

  /// False: the end, or nothing grows any more.
  template <class Visit> bool pass(const Visit& visit) {
    const double s_before = s_;
    const std::vector<OverloadMemory> before = memory_;
    done_ = 0.0;
    if (std::ranges::any_of(tip_K_, [](const KOfLoads& K) { return K.turns(); })) {
      pass_on_K(visit);
    } else {
      pass_of_loads(visit);
    }
    passes_ += 1.0;
    return !stopped_ && (s_ > s_before || memory_ != before);
  }
  [[nodiscard]] double cycles() const { return passes_ * whole_.cycles_per_pass_; }

private:
  void enter_interval() {
    for (KOfLoads& K : tip_K_) {
      K.enter(interval_);
    }
  }

  // Into the interval of s; what a passage has taken away is remembered no more.
  void follow_s() {
    while (interval_ + 2 < whole_.stations_.size() && s_ > whole_.stations_[interval_ + 1].s) {
      ++interval_;
      if (const std::size_t through = whole_.stations_[interval_].breakthroughs; through > 0) {
        memory_[through - 1] = OverloadMemory();
      }
      enter_interval();
    }
  }

  template <class Visit> void pass_of_loads(const Visit& visit) {
    const auto K_of = [&](std::size_t tip, const LoadCycle& loads, double count) {
      // K may fall while the load rises.
      const auto [low, high] = std::minmax({tip_K_[tip].K(loads.low), tip_K_[tip].K(loads.high)});
      return LoadCycle{low, high, count};
    };
    const LoadCycle ends{whole_.spectrum_.lowest_load(), whole_.spectrum_.highest_load(), 1.0};
    for (const LoadCycle& cycle : whole_.spectrum_.cycles_in_order()) {
      for (double left = cycle.count; left > 0.0 && !stopped_; left -= 1.0) {
        const double count = std::min(left, 1.0);
        step(
            count / whole_.cycles_per_pass_, visit,
            [&](std::size_t tip) { return K_of(tip, cycle, count); },
            [&](std::size_t tip) { return K_of(tip, ends, 1.0); });
      }
    }
  }

  // K of the pass at its beginning is that of all of it, but for the size of K.
  template <class Visit> void pass_on_K(const Visit& visit) {
    std::vector<std::vector<LoadCycle>> cycles(tips_);
    std::vector<LoadCycle> extremes(tips_);
    std::vector<double> scale(tips_);
    std::size_t most = 0;
    for (std::size_t tip = 0; tip < tips_; ++tip) {
      tip_K_[tip].go_to(s_);
      scale[tip] = tip_K_[tip].scale();
      cycles[tip] = one_by_one(whole_.spectrum_.cycles_in_order_as_K(tip_K_[tip].path()));
      extremes[tip] = life::extreme_loads(cycles[tip]);
      most = std::max(most, cycles[tip].size());
    }
    for (std::size_t k = 0; k < most && !stopped_; ++k) {
      const auto now = [&](std::size_t tip, const LoadCycle& cycle) {
        const double by = tip_K_[tip].scale() / scale[tip];
        return LoadCycle{by * cycle.low, by * cycle.high, cycle.count};
      };
      step(
          1.0 / static_cast<double>(most), visit,
          [&](std::size_t tip) {
            // A tip with fewer cycles rests at the end of the pass.
            return k < cycles[tip].size() ? now(tip, cycles[tip][k]) : LoadCycle{0.0, 0.0, 0.0};
          },
          [&](std::size_t tip) { return now(tip, extremes[tip]); });
    }
  }

  static std::vector<LoadCycle> one_by_one(const std::vector<LoadCycle>& counted) {
    std::vector<LoadCycle> all;
    for (const LoadCycle& cycle : counted) {
      for (double left = cycle.count; left > 0.0; left -= 1.0) {
        all.push_back({cycle.low, cycle.high, std::min(left, 1.0)});
      }
    }
    return all;
  }

  // All tips by one cycle, which is `part` of the pass.
  template <class Visit, class CycleOfTip, class PassOfTip>
  void step(double part, const Visit& visit, const CycleOfTip& cycle_of,
            const PassOfTip& whole_pass) {
    double next = s_;
    for (std::size_t tip = 0; tip < tips_; ++tip) {
      KOfLoads& here = tip_K_[tip];
      here.go_to(s_);
      const LoadCycle cycle = cycle_of(tip);
      next +=
          cycle.count * here.rate_ratio() *
          interaction_.growth(cycle.high, cycle.low, whole_pass(tip), here.place(), memory_[tip]);
    }
    const double before = passes_ + done_;
    done_ += part;
    stopped_ = !visit(s_, next, before, passes_ + done_) || !(next < whole_.stations_.back().s);
    s_ = next;
    follow_s();
  }

  const CycleByCycleGrowth& whole_;
  const LoadInteraction& interaction_;
  std::size_t tips_;
  std::vector<OverloadMemory> memory_;
  double s_;
  double passes_ = 0.0, done_ = 0.0; ///< done: part of the pass that runs
  bool stopped_ = false;
  std::size_t interval_ = 0;
  std::vector<KOfLoads> tip_K_;
};

CycleByCycleGrowth::CycleByCycleGrowth(const std::vector<SolvedStation>& stations,
                                       const life::CountedSpectrum& spectrum)
    : stations_(stations), spectrum_(spectrum), cycles_per_pass_(spectrum.cycles_per_pass()) {
  assert(stations.size() >= 2);
}

std::optional<std::vector<double>> CycleByCycleGrowth::passes_at(const std::vector<double>& places,
                                                                 const LoadInteraction& interaction,
                                                                 double most_cycles) const {
  std::vector<double> passes;
  Run run(*this, interaction);
  const auto visit = [&](double s, double next, double before, double after) {
    while (passes.size() < places.size() && places[passes.size()] <= next) {
      // Within a cycle the length grows evenly.
      const double part =
          std::isfinite(next) && next > s ? (places[passes.size()] - s) / (next - s) : 0.0;
      passes.push_back(before + std::max(part, 0.0) * (after - before));
    }
    return passes.size() < places.size();
  };
  while (passes.size() < places.size() && run.cycles() <= most_cycles && run.pass(visit)) {
  }
  if (passes.size() < places.size() && run.cycles() > most_cycles) {
    return std::nullopt;
  }
  passes.resize(places.size(), infinite);
  return passes;
}

std::optional<double> CycleByCycleGrowth::extent_after_passes(double passes,
                                                              const LoadInteraction& interaction,
                                                              double most_cycles) const {
  std::optional<double> found;
  Run run(*this, interaction);
  const auto visit = [&](double s, double next, double before, double after) {
    if (after >= passes) {
      found = s + (next - s) * (passes - before) / (after - before);
    }
    return !found;
  };
  while (run.cycles() <= most_cycles && run.pass(visit)) {
  }
  return found && *found <= stations_.back().s ? found : std::nullopt;
}

} // namespace spricka::growth
