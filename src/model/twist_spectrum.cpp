// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/twist_spectrum.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>

#include <fmt/format.h>

namespace spricka::model {

namespace {

constexpr double on_ground = -0.5; // over the mean stress in flight

constexpr std::array<const char*, twist_levels> level_names{"I",  "II",  "III",  "IV", "V",
                                                            "VI", "VII", "VIII", "IX", "X"};

struct FlightType {
  int flights; ///< of 4000
  std::array<int, twist_levels> gusts;
};

// Amplitudes of the levels I to X over the mean stress in flight.
constexpr std::array<double, twist_levels> amplitudes{1.60, 1.50,  1.30, 1.15,  0.995,
                                                      0.84, 0.685, 0.53, 0.375, 0.222};

// The flight types A to J.
constexpr std::array<FlightType, 10> flight_types{{{1, {1, 1, 1, 4, 8, 18, 64, 112, 391, 900}},
                                                   {1, {0, 1, 1, 2, 5, 11, 39, 76, 366, 899}},
                                                   {3, {0, 0, 1, 1, 2, 7, 22, 61, 277, 879}},
                                                   {9, {0, 0, 0, 1, 1, 2, 14, 44, 208, 680}},
                                                   {24, {0, 0, 0, 0, 1, 1, 6, 24, 165, 603}},
                                                   {60, {0, 0, 0, 0, 0, 1, 3, 19, 115, 512}},
                                                   {181, {0, 0, 0, 0, 0, 0, 1, 7, 70, 412}},
                                                   {420, {0, 0, 0, 0, 0, 0, 0, 1, 16, 233}},
                                                   {1090, {0, 0, 0, 0, 0, 0, 0, 0, 1, 69}},
                                                   {2211, {0, 0, 0, 0, 0, 0, 0, 0, 0, 25}}}};

class Shuffler {
public:
  explicit Shuffler(std::uint32_t seed) : state_(seed & mask) {}

  template <class Value> void shuffle(std::vector<Value>& values) {
    for (std::size_t i = values.size(); i-- > 1;) {
      const auto j = static_cast<std::size_t>(next() * static_cast<double>(i + 1));
      std::swap(values[i], values[j]);
    }
  }

private:
  static constexpr std::uint32_t mask = 0x7fffffffU;

  // In [0, 1).
  double next() {
    state_ = (1103515245U * state_ + 12345U) & mask;
    return static_cast<double>(state_) / 2147483648.0;
  }

  std::uint32_t state_;
};

} // namespace

TwistHistory generate_twist_history(const TwistSettings& settings) {
  Shuffler order(settings.seed);
  std::vector<std::size_t> flights;
  for (std::size_t type = 0; type < flight_types.size(); ++type) {
    flights.insert(flights.end(), static_cast<std::size_t>(flight_types[type].flights), type);
  }
  order.shuffle(flights);
  TwistHistory out;
  out.flights = static_cast<double>(flights.size());
  std::vector<int> gusts; // levels of a flight
  for (const std::size_t type : flights) {
    gusts.clear();
    for (int level = 0; level <= settings.lowest_level; ++level) {
      const auto l = static_cast<std::size_t>(level);
      gusts.insert(gusts.end(), static_cast<std::size_t>(flight_types[type].gusts[l]), level);
    }
    order.shuffle(gusts);
    out.points.push_back(on_ground);
    if (gusts.empty()) {
      out.points.push_back(1.0);
      continue;
    }
    for (const int level : gusts) {
      const double up =
          amplitudes[static_cast<std::size_t>(std::max(level, settings.highest_level))];
      out.points.push_back(1.0 + up);
      out.points.push_back(1.0 - up);
    }
    out.points.pop_back(); // the load goes on down to the ground
  }
  return out;
}

std::string describe_twist_history(const TwistSettings& settings) {
  std::string text = fmt::format("TWIST statistics, order by our own generator (seed {}); not the "
                                 "standard's sequence",
                                 settings.seed);
  const auto name = [](int level) { return level_names[static_cast<std::size_t>(level)]; };
  if (settings.highest_level > 0) {
    text += fmt::format("; gusts above level {} cut down to it", name(settings.highest_level));
  }
  if (settings.lowest_level + 1 < twist_levels) {
    text += fmt::format("; gusts below level {} left out", name(settings.lowest_level));
  }
  return text;
}

std::vector<double> twist_gust_counts() {
  std::vector<double> counts(twist_levels, 0.0);
  for (const FlightType& type : flight_types) {
    for (std::size_t level = 0; level < counts.size(); ++level) {
      counts[level] += static_cast<double>(type.flights * type.gusts[level]);
    }
  }
  return counts;
}

} // namespace spricka::model
