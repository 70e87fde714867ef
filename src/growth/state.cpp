// SPDX-License-Identifier: GPL-3.0-or-later
#include "growth/state.hpp"

#include <array>
#include <stdexcept>

namespace spricka::growth {

namespace {

// The order of values in restart files; files with more or fewer are refused by their length.
constexpr std::array tip_values{&TipStation::a,
                                &TipStation::K_max,
                                &TipStation::K_min,
                                &TipStation::K2_max,
                                &TipStation::rate,
                                &TipStation::turn,
                                &TipStation::heading,
                                &TipStation::x,
                                &TipStation::y,
                                &TipStation::z,
                                &TipStation::extent_rate_ratio,
                                &TipStation::plastic,
                                &TipStation::deferred_advance,
                                &TipStation::uncertain_fraction,
                                &TipStation::first_max,
                                &TipStation::first_min,
                                &TipStation::passes,
                                &TipStation::change};

/// Reads an array from its beginning; whether it held enough is known at the end.
class StateArrayReader {
public:
  StateArrayReader(const Arrays& arrays, const std::string& name) {
    const auto found = arrays.find(name);
    values_ = found != arrays.end() ? &found->second : nullptr;
    good_ = values_ != nullptr;
  }
  double next() {
    good_ = good_ && at_ < values_->size();
    return good_ ? (*values_)[at_++] : 0.0;
  }
  /// The next one, which counts something; one that does not is none.
  std::size_t count() {
    const double value = next();
    good_ = good_ && value >= 0.0 && value <= most;
    return good_ ? static_cast<std::size_t>(value) : 0;
  }
  [[nodiscard]] bool finished() const { return good_ && at_ == values_->size(); }
  [[nodiscard]] std::size_t left() const { return good_ ? values_->size() - at_ : 0; }

private:
  static constexpr double most = 1e9; // more of anything is damage
  const std::vector<double>* values_ = nullptr;
  std::size_t at_ = 0;
  bool good_ = false;
};

} // namespace

Arrays to_arrays(const GrowthState& state) {
  Arrays out;
  std::vector<double>& control = out["control"];
  control = {static_cast<double>(state.stations.size()),
             static_cast<double>(state.stations.empty() ? 0 : state.stations.front().tips.size()),
             state.step, static_cast<double>(state.rejected)};
  std::vector<double>& stations = out["stations"];
  for (const SolvedStation& station : state.stations) {
    stations.push_back(station.s);
    stations.push_back(static_cast<double>(station.breakthroughs));
    stations.push_back(static_cast<double>(station.met));
    for (const TipStation& tip : station.tips) {
      for (const auto value : tip_values) {
        stations.push_back(tip.*value);
      }
    }
  }
  std::vector<double>& points = out["points"];
  std::vector<double>& counts = out["line_points"];
  for (const std::vector<base::Vec3>& line : state.lines) {
    counts.push_back(static_cast<double>(line.size()));
    for (const base::Vec3& x : line) {
      points.insert(points.end(), {x.x(), x.y(), x.z()});
    }
  }
  return out;
}

std::size_t checked_index(double number, std::size_t count) {
  if (!(number >= 0.0 && number < static_cast<double>(count))) {
    throw std::out_of_range("an index that names nothing");
  }
  return static_cast<std::size_t>(number);
}

std::optional<GrowthState> from_arrays(const Arrays& arrays) {
  GrowthState state;
  StateArrayReader control(arrays, "control");
  StateArrayReader stations(arrays, "stations");
  StateArrayReader counts(arrays, "line_points");
  StateArrayReader points(arrays, "points");
  const std::size_t count = control.count();
  const std::size_t tips = control.count();
  state.step = control.next();
  state.rejected = static_cast<int>(control.count());
  // Before anything is sized by these numbers: files may be broken.
  if (!control.finished() || stations.left() != count * (3 + tips * tip_values.size())) {
    return std::nullopt;
  }
  for (std::size_t i = 0; i < count; ++i) {
    SolvedStation station;
    station.s = stations.next();
    station.breakthroughs = stations.count();
    station.met = stations.count();
    station.tips.resize(tips);
    for (TipStation& tip : station.tips) {
      for (const auto value : tip_values) {
        tip.*value = stations.next();
      }
    }
    state.stations.push_back(std::move(station));
  }
  while (counts.left() > 0) {
    const std::size_t n = counts.count();
    if (3 * n > points.left()) {
      return std::nullopt;
    }
    std::vector<base::Vec3>& line = state.lines.emplace_back(n);
    for (base::Vec3& x : line) {
      x = {points.next(), points.next(), points.next()};
    }
  }
  if (!stations.finished() || !counts.finished() || !points.finished()) {
    return std::nullopt;
  }
  return state;
}

} // namespace spricka::growth
