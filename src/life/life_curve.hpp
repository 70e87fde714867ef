// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "geometry/cubic_spline.hpp"
#include "life/integrate.hpp"

#include <vector>

namespace spricka::life {

/// The life between stations of one crack: log(rate) is interpolated over log(a) by a cubic spline
/// (life.12), cycles (or passes) are the integral of da / rate (life.13).
class LifeCurve {
public:
  /// a [>= 2] ascending lengths > 0; rate [a] growth per cycle, or per pass, > 0.
  LifeCurve(const std::vector<double>& a, const std::vector<double>& rate);

  [[nodiscard]] double first_length() const { return a_.front(); }
  [[nodiscard]] double last_length() const { return a_.back(); }

  /// Growth per cycle; not a number outside the stations, here and below.
  [[nodiscard]] double growth_rate(double a) const;
  /// Cycles from a0 to a1 >= a0, to 1e-12 of them; what the quadrature leaves is in `error`.
  [[nodiscard]] double cycles(double a0, double a1) const;
  /// The length after N cycles from the first station.
  [[nodiscard]] double length_at(double N) const;

  /// How far `cycles` may be off because there are no more stations: each inner station in turn is
  /// left out, and by what the spline then misses it is taken to be wrong on both sides (life.14).
  /// With it what the quadratures left. Infinite with two stations.
  [[nodiscard]] double cycles_error(double a0, double a1) const;

private:
  [[nodiscard]] bool within(double a0, double a1) const;
  [[nodiscard]] double miss(double x) const;
  [[nodiscard]] Integral integrated_cycles(double a0, double a1) const;

  std::vector<double> a_;
  geometry::CubicSpline<double> log_rate_; ///< over log(a)
  /// [station - 1] log_rate_ without an inner station
  std::vector<geometry::CubicSpline<double>> without_;
  std::vector<double> at_; ///< [station] cycles from the first one
};

} // namespace spricka::life
