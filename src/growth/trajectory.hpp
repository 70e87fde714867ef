// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/piecewise_linear.hpp"
#include "life/rainflow.hpp"
#include "model/crack_growth.hpp"
#include "model/law_use.hpp"

#include <array>
#include <cstddef>
#include <functional>
#include <optional>
#include <type_traits>
#include <utility>
#include <vector>

/// Growth between the stations where K is known: interpolated K or rates, cycles by quadrature.
namespace spricka::growth {

/// What is known of one tip at a station.
struct TipStation {
  double a = 0.0;                 ///< its arm: first length and all it has grown [length]
  double K_max = 0.0;             ///< given to the law [stress * length^0.5]
  double K_min = 0.0;             ///< given to the law
  double K2_max = 0.0;            ///< before the turn
  double rate = 0.0;              ///< of its arm [length per cycle or per pass]
  double extent_rate_ratio = 1.0; ///< that over the rate where K is, if the arm ends elsewhere
  double turn = 0.0;              ///< the way on against the crack's last part [rad]
  double heading = 0.0;           ///< the way on, from +x [rad]
  double x = 0.0, y = 0.0, z = 0.0;
  double deferred_advance =
      0.0; ///< what the rates found since would have made of the arm more [length]
  double uncertain_fraction = 0.0; ///< part of its rate that may be wrong for its deferred advance
  double toughness = 0.0;          ///< in place of the law's own; 0: that [stress intensity]
  double plastic = 0.0;            ///< force and moment over the ligament, over their plastic limit
  /// Where friction makes K a history: K of its first cycle or pass, passes until it repeated
  /// itself, and what still changed in the last one over the largest K.
  double first_max = 0.0, first_min = 0.0, passes = 0.0, change = 0.0;
  /// Of a spectrum: K given to the law over the place on the load path.
  base::PiecewiseLinear K_over_path{};
  /// Where friction makes K a history and cycles act on each other: those of the pass that was
  /// followed, in order.
  std::vector<life::LoadCycle> cycles_of_K{};
  model::LawUse law_use = {}; ///< of its cycle or pass
};

/// Where a tip asks the law, with its arm `a`.
inline model::PlaceOnCrack place_of_tip(const TipStation& tip, double a) {
  return {a, tip.toughness > 0.0 ? std::optional(tip.toughness) : std::nullopt};
}

/// Curvature of the way of a tip from one station to the next [rad/length], left positive; 0 where
/// it has not grown.
double tip_path_curvature(const TipStation& before, const TipStation& here);

/// All growing tips at one state of the cracks.
struct SolvedStation {
  double s = 0.0; ///< sum of the arms
  std::vector<TipStation> tips;
  /// The tip (counted from 1) that has gone through a surface on the way to it; no polynomial leads
  /// over that. 0: none has.
  std::size_t breakthroughs = 0;
  std::size_t met = 0; ///< the crack (counted from 1) that this tip's has joined on that way

  [[nodiscard]] double growth_rate() const; ///< ds per cycle
};

/// Stations that a polynomial leads through.
struct StationRange {
  std::size_t first = 0, points = 0;
};
/// Of the stations from `low` to before `high` up to `points` nearest to an interval, with no
/// passage between them: as many on either side as there are.
StationRange nearest_stations(const std::vector<SolvedStation>& stations, std::size_t interval,
                              std::size_t points, std::size_t low, std::size_t high);

/// The arm of a tip from one station to the next, by a cubic of which the arms of all tips add up
/// to s [length].
class ExtentOverInterval {
public:
  ExtentOverInterval(const SolvedStation& left, const SolvedStation& right, std::size_t tip);
  [[nodiscard]] double operator()(double s) const {
    const double t = (s - s_) / h_;
    return a_ + t * difference_ + t * (1.0 - t) * ((1.0 - t) * left_ + t * right_);
  }

private:
  double s_, h_, a_, difference_;
  double left_ = 0.0, right_ = 0.0; ///< Hermite: what the slopes at the ends add
};

/// The rate of an arm over that of the place where K is, straight between two stations: it changes
/// slowly, and never below 0.
double extent_rate_ratio(const SolvedStation& left, const SolvedStation& right, std::size_t tip,
                         double s);

/// da/dN at K_max and K_min of a place.
template <class Law>
concept RateOfCycle =
    std::is_invocable_r_v<double, Law, double, double, const model::PlaceOnCrack&>;

/// Rates between stations: da/dN of a cycle at K_max and K_min of a place, or da of a pass of a
/// spectrum whose K over the load path is known. Empty: the stations' rates are interpolated.
class GrowthRateFunction {
public:
  using OfCycle =
      std::function<double(double K_max, double K_min, const model::PlaceOnCrack& place)>;
  using OfPass =
      std::function<double(const base::PiecewiseLinear& K, const model::PlaceOnCrack& place)>;

  GrowthRateFunction() = default;
  template <RateOfCycle Law>
  GrowthRateFunction(Law law) // NOLINT(google-explicit-constructor): laws are given as functions
      : of_cycle(std::move(law)) {}
  static GrowthRateFunction of_passes(OfPass pass) {
    GrowthRateFunction rates;
    rates.of_pass = std::move(pass);
    return rates;
  }

  /// da/dN of a cycle.
  double operator()(double K_max, double K_min, const model::PlaceOnCrack& place) const {
    return of_cycle(K_max, K_min, place);
  }

  OfCycle of_cycle;
  OfPass of_pass; ///< only where the stations have TipStation::K_over_path
};

/// Functions of s between stations by polynomials through the nearest of them: ln K_max, K_min and
/// K of other loads over K_max (or ln rate) over ln s; arms by cubics that take the rates as slopes
/// (manual, growth.3).
class GrowthTrajectory {
public:
  /// stations [>= 1], s ascending; `points` of each polynomial, at most 4 and as many as there are.
  GrowthTrajectory(const std::vector<SolvedStation>& stations, GrowthRateFunction law,
                   std::size_t points);

  /// Rate of the sum of all arms at s, added up over the tips [length/cycle].
  [[nodiscard]] double growth_rate(double s) const; ///< ds per cycle
  /// Largest K of a tip at s, interpolated by its logarithm where all stations have a positive one.
  [[nodiscard]] double K_max(std::size_t tip, double s) const;
  /// Plastic load ratio of a tip, interpolated between the stations.
  [[nodiscard]] double plastic_load_ratio(std::size_t tip, double s) const;
  /// Arm of a tip at s, by a cubic of which the arms of all tips add up to s [length].
  [[nodiscard]] double crack_extent(std::size_t tip, double s) const;
  /// Cycles from s0 to s1, both within the stations: Gauss on parts of each interval (growth.4).
  [[nodiscard]] double cycles(double s0, double s1) const;
  /// Where so many cycles from s0 lead; empty: beyond the last station.
  [[nodiscard]] std::optional<double> extent_after_cycles(double s0, double cycles) const;

private:
  [[nodiscard]] std::size_t interval(double s) const;
  /// Lagrange's polynomial in ln s at one s: what the values of so many stations count.
  struct StationWeights : StationRange {
    std::array<double, 4> weight{};
  };
  [[nodiscard]] StationWeights weights_at(std::size_t interval, double s, std::size_t low,
                                          std::size_t high) const;
  template <class Value>
  double interpolate(const StationWeights& weights, const Value& value) const;
  [[nodiscard]] double K_max(std::size_t tip, const StationWeights& weights) const;
  [[nodiscard]] double tip_rate(std::size_t tip, std::size_t interval, double s,
                                const StationWeights& weights) const;
  [[nodiscard]] base::PiecewiseLinear K_over_path(std::size_t tip,
                                                  const StationWeights& weights) const;
  [[nodiscard]] double interpolated_rate(std::size_t tip, std::size_t interval, double s,
                                         const StationWeights& weights) const;
  [[nodiscard]] double gauss(double s0, double s1) const;

  const std::vector<SolvedStation>& stations_;
  GrowthRateFunction law_;
  std::size_t points_;
  std::vector<double> ln_s_;                  ///< [station]
  std::vector<std::vector<double>> ln_K_max_; ///< [tip][station], of closed ones empty
  bool extents_differ_ = false;               ///< some arm does not grow as its place does
  bool paths_ = false;                        ///< K over the load path is known everywhere
};

/// First place between s0 and s1 (found to 1e-12 of s1) where `value` is not below 0 any more, if
/// it is at s1; it is looked at in some places between.
std::optional<double> find_first_crossing(const std::function<double(double)>& value, double s0,
                                          double s1);

} // namespace spricka::growth
