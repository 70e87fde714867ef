// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <cstdint>
#include <string>
#include <vector>

/// TWIST, the load spectrum of a transport aircraft's wing root: its published statistics of
/// flights and gusts (de Jonge, Schuetz, Lowak and Schijve 1973, NLR TR 73029 and LBF FB-106) in an
/// order of our own, which is not the standard's sequence.
namespace spricka::model {

/// Levels count from 0 (I, the largest gust) to 9 (X).
struct TwistSettings {
  int highest_level = 0; ///< gusts of higher levels become this one
  int lowest_level = 9;  ///< gusts of lower levels are left out
  std::uint32_t seed = 1;
};

struct TwistHistory {
  std::vector<double> points; ///< turning points, in parts of the mean stress in flight
  double flights = 0.0;
};

inline constexpr int twist_levels = 10;

/// A pass of 4000 flights, each from the ground (-0.5) through its gusts, up and down about 1. The
/// order of flights, and of gusts in a flight, is shuffled (Fisher and Yates, by the generator
/// x' = (1103515245 x + 12345) mod 2^31 from `seed`): the same on every machine.
TwistHistory generate_twist_history(const TwistSettings& settings);

/// What such a history is, a sentence: "TWIST statistics, order by our own generator (seed 1); ..".
std::string describe_twist_history(const TwistSettings& settings);

/// Gust cycles of the table by level, in 4000 flights. [level]
std::vector<double> twist_gust_counts();

} // namespace spricka::model
