// SPDX-License-Identifier: GPL-3.0-or-later
#include "growth/state.hpp"

#include "base/damaged_field.hpp"

#include <array>
#include <cmath>
#include <cstdint>
#include <string_view>
#include <type_traits>
#include <utility>

#include <fmt/format.h>

namespace spricka::growth {

namespace {

using base::Vec3;

/// Files of earlier versions do not have it.
constexpr const char* tip_toughness = "station_tip.toughness";

constexpr std::array tip_values{
    std::pair("station_tip.a", &TipStation::a),
    std::pair("station_tip.K_max", &TipStation::K_max),
    std::pair("station_tip.K_min", &TipStation::K_min),
    std::pair("station_tip.K2_max", &TipStation::K2_max),
    std::pair("station_tip.rate", &TipStation::rate),
    std::pair("station_tip.extent_rate_ratio", &TipStation::extent_rate_ratio),
    std::pair("station_tip.turn", &TipStation::turn),
    std::pair("station_tip.heading", &TipStation::heading),
    std::pair("station_tip.x", &TipStation::x),
    std::pair("station_tip.y", &TipStation::y),
    std::pair("station_tip.z", &TipStation::z),
    std::pair("station_tip.deferred_advance", &TipStation::deferred_advance),
    std::pair("station_tip.uncertain_fraction", &TipStation::uncertain_fraction),
    std::pair("station_tip.plastic", &TipStation::plastic),
    std::pair("station_tip.first_max", &TipStation::first_max),
    std::pair("station_tip.first_min", &TipStation::first_min),
    std::pair("station_tip.passes", &TipStation::passes),
    std::pair("station_tip.change", &TipStation::change),
    std::pair(tip_toughness, &TipStation::toughness)};

/// Files of earlier versions have none of these.
constexpr std::array law_use_values{
    std::pair("station_tip.law.lowest_delta_k", &model::LawUse::lowest_delta_k),
    std::pair("station_tip.law.highest_delta_k", &model::LawUse::highest_delta_k),
    std::pair("station_tip.law.lowest_ratio", &model::LawUse::lowest_ratio),
    std::pair("station_tip.law.highest_ratio", &model::LawUse::highest_ratio),
    std::pair("station_tip.law.outside", &model::LawUse::outside),
    std::pair("station_tip.law.growth_outside", &model::LawUse::growth_outside),
    std::pair("station_tip.law.below_delta_k", &model::LawUse::below_delta_k),
    std::pair("station_tip.law.above_delta_k", &model::LawUse::above_delta_k),
    std::pair("station_tip.law.below_ratio", &model::LawUse::below_ratio),
    std::pair("station_tip.law.above_ratio", &model::LawUse::above_ratio)};

/// Appends values to an array.
struct ColumnWriter {
  std::vector<double>& values;

  template <class Value> void value(const Value& x) {
    if constexpr (std::is_same_v<Value, Vec3>) {
      values.insert(values.end(), {x.x(), x.y(), x.z()});
    } else {
      values.push_back(static_cast<double>(x));
    }
  }
};

/// Writes what describe() names.
struct StateWriter {
  NamedValueArrays arrays;

  ColumnWriter column(const char* name) { return {arrays[name]}; }
  [[nodiscard]] bool has(const char* /*name*/) const { return true; }
  [[nodiscard]] bool has_if(const char* /*name*/, bool there) const { return there; }
  template <class List> void resize(const char* /*name*/, const List& /*list*/) {}
  void spread(const char* /*name*/, const std::vector<SolvedStation>& /*stations*/) {}
  template <class List> void count(const char* name, const List& list, const char* /*items*/) {
    column(name).value(list.size());
  }
};

/// Takes values from an array, one after another.
class ColumnReader {
public:
  ColumnReader(std::string name, std::vector<double> values)
      : name_(std::move(name)), values_(std::move(values)) {}

  template <class Value> void value(Value& x) {
    if constexpr (std::is_same_v<Value, Vec3>) {
      for (int i = 0; i < 3; ++i) {
        x[i] = next();
      }
    } else if constexpr (std::is_floating_point_v<Value>) {
      x = next();
    } else {
      x = static_cast<Value>(whole());
    }
  }
  [[nodiscard]] std::size_t left() const { return values_.size() - at_; }
  [[nodiscard]] std::size_t size() const { return values_.size(); }
  void finish() const {
    if (left() > 0) {
      throw base::CorruptStoredField(name_, fmt::format("{} values too many", left()));
    }
  }

private:
  double next() {
    if (left() == 0) {
      throw base::CorruptStoredField(name_, fmt::format("{} values are too few", values_.size()));
    }
    return values_[at_++];
  }
  // One that counts or names something.
  std::int64_t whole() {
    constexpr double most = 1e9; // more of anything is damage
    const double value = next();
    if (!(value >= 0.0 && value <= most && value == std::floor(value))) {
      throw base::CorruptStoredField(name_, fmt::format("{:.6g} is no number of anything", value));
    }
    return static_cast<std::int64_t>(value);
  }

  std::string name_;
  std::vector<double> values_;
  std::size_t at_ = 0;
};

/// Reads what describe() names.
class StateReader {
public:
  explicit StateReader(const NamedValueArrays& arrays) : arrays_(arrays) {}

  ColumnReader& column(const char* name) {
    const auto found = arrays_.find(name);
    return columns_
        .try_emplace(name, name, found != arrays_.end() ? found->second : std::vector<double>())
        .first->second;
  }
  [[nodiscard]] bool has(const char* name) const { return arrays_.contains(name); }
  [[nodiscard]] bool has_if(const char* name, bool /*there*/) const { return has(name); }
  template <class List> void resize(const char* name, List& list) {
    list.resize(column(name).size());
  }
  // All stations have as many tips.
  void spread(const char* name, std::vector<SolvedStation>& stations) {
    const std::size_t count = stations.empty() ? 0 : column(name).size() / stations.size();
    for (SolvedStation& station : stations) {
      station.tips.resize(count);
    }
  }
  // Before anything is sized by a count: there must be as many items.
  template <class List> void count(const char* name, List& list, const char* items) {
    std::size_t count = 0;
    column(name).value(count);
    if (count > column(items).left()) {
      throw base::CorruptStoredField(name,
                                     fmt::format("it counts {} of {}, which has {} values left",
                                                 count, items, column(items).left()));
    }
    list.resize(count);
  }
  void finish() const {
    for (const auto& [name, column] : columns_) {
      column.finish();
    }
  }

private:
  const NamedValueArrays& arrays_;
  std::map<std::string, ColumnReader> columns_;
};

template <class Io, class Points>
void describe_points(Io& io, const char* count, const char* name, Points& points) {
  io.count(count, points, name);
  auto&& column = io.column(name);
  for (auto& x : points) {
    column.value(x);
  }
}

template <class Io, class Crack> void describe_crack(Io& io, Crack& crack) {
  io.column("crack.kind").value(crack.kind);
  io.column("crack.place").value(crack.plane.place);
  io.column("crack.normal").value(crack.plane.normal);
  io.column("crack.along").value(crack.plane.along);
  io.column("crack.a").value(crack.plane.a);
  io.column("crack.c").value(crack.plane.c);
  io.column("crack.closed").value(crack.plane.closed);
  describe_points(io, "crack.points", "crack_point.x", crack.points);
  io.count("crack.history", crack.history.fronts, "history_front.points");
  for (auto& front : crack.history.fronts) {
    describe_points(io, "history_front.points", "history_point.x", front);
  }
  describe_points(io, "crack.normals", "history_normal.x", crack.history.normals);
}

constexpr const char* path_knots = "station_tip.path_knots";
constexpr const char* tip_cycles = "station_tip.cycles";

// Segments by their beginning, value and slope, and the last knot.
template <class Io, class Path> void describe_path(Io& io, Path& path) {
  struct Segment {
    double begin, value, slope;
  };
  std::vector<Segment> segments(path.segment_count());
  for (std::size_t k = 0; k < segments.size(); ++k) {
    segments[k] = {path.knots()[k], path.segment_start_values()[k], path.slope(k)};
  }
  double last = path.empty() ? 0.0 : path.knots().back();
  io.count(path_knots, segments, "path_segment.begin");
  for (Segment& segment : segments) {
    io.column("path_segment.begin").value(segment.begin);
    io.column("path_segment.value").value(segment.value);
    io.column("path_segment.slope").value(segment.slope);
  }
  io.column("path_segment.last").value(last);
  if constexpr (!std::is_const_v<Path>) {
    if (!segments.empty()) {
      std::vector<double> knots, values, slopes;
      for (const Segment& segment : segments) {
        knots.push_back(segment.begin);
        values.push_back(segment.value);
        slopes.push_back(segment.slope);
      }
      knots.push_back(last);
      if (!std::ranges::is_sorted(knots, std::less_equal<>())) {
        throw base::CorruptStoredField("path_segment.begin", "the knots of a path do not ascend");
      }
      path = base::PiecewiseLinear(std::move(knots), std::move(values), std::move(slopes));
    }
  }
}

// K over the load path of each tip under a spectrum, and where cycles act on each other with
// friction those of the pass that was followed.
template <class Io, class Stations> void describe_cycles(Io& io, Stations& stations) {
  const bool has = std::ranges::any_of(stations, [](const SolvedStation& station) {
    return std::ranges::any_of(station.tips, [](const TipStation& tip) {
      return !tip.K_over_path.empty() || !tip.cycles_of_K.empty();
    });
  });
  if (!io.has_if(path_knots, has)) {
    return;
  }
  for (auto& station : stations) {
    for (auto& tip : station.tips) {
      describe_path(io, tip.K_over_path);
      io.count(tip_cycles, tip.cycles_of_K, "tip_cycle.low");
      for (auto& cycle : tip.cycles_of_K) {
        io.column("tip_cycle.low").value(cycle.low);
        io.column("tip_cycle.high").value(cycle.high);
        io.column("tip_cycle.count").value(cycle.count);
      }
    }
  }
}

template <class Io, class Stations> void describe_law_use(Io& io, Stations& stations) {
  for (const auto& [name, member] : law_use_values) {
    if (!io.has(name)) {
      continue;
    }
    auto&& column = io.column(name);
    for (auto& station : stations) {
      for (auto& tip : station.tips) {
        column.value(tip.law_use.*member);
      }
    }
  }
}

// The state's arrays, in the same way for both directions.
template <class Io, class State> void describe(Io& io, State& state) {
  io.column("growth.step").value(state.step);
  io.column("growth.rejected").value(state.rejected);
  io.resize("station.s", state.stations);
  for (auto& station : state.stations) {
    io.column("station.s").value(station.s);
    io.column("station.breakthroughs").value(station.breakthroughs);
    io.column("station.met").value(station.met);
  }
  io.spread("station_tip.a", state.stations);
  for (const auto& [name, member] : tip_values) {
    if (std::string_view(name) == tip_toughness && !io.has(name)) {
      continue;
    }
    auto&& column = io.column(name);
    for (auto& station : state.stations) {
      for (auto& tip : station.tips) {
        column.value(tip.*member);
      }
    }
  }
  describe_law_use(io, state.stations);
  describe_cycles(io, state.stations);
  io.resize("crack.kind", state.cracks);
  for (auto& crack : state.cracks) {
    describe_crack(io, crack);
  }
  io.resize("tip.crack", state.tips);
  for (auto& tip : state.tips) {
    io.column("tip.crack").value(tip.crack);
    io.column("tip.front").value(tip.front);
    io.column("tip.number").value(tip.number);
    io.column("tip.on_a").value(tip.on_a);
    io.column("tip.sign").value(tip.sign);
    io.column("tip.paired").value(tip.paired);
    io.column("tip.shared").value(tip.shared);
  }
}

void check_names(const GrowthState& state) {
  for (const GrownCrack& crack : state.cracks) {
    if (crack.kind > model::CrackDefinitionKind::drawn) {
      throw base::CorruptStoredField("crack.kind", "no kind of crack");
    }
    const std::vector<std::vector<Vec3>>& fronts = crack.history.fronts;
    if (crack.history.normals.size() != (fronts.empty() ? 0 : fronts.back().size())) {
      throw base::CorruptStoredField("crack.normals", "normals of another front");
    }
    for (const std::vector<Vec3>& front : fronts) {
      if (front.size() < 2) {
        throw base::CorruptStoredField("history_front.points", "a front without a line");
      }
    }
  }
  for (const PartMovedByTip& tip : state.tips) {
    if (tip.crack >= state.cracks.size()) {
      throw base::CorruptStoredField("tip.crack", fmt::format("there is no crack {}", tip.crack));
    }
    if (tip.front >= state.tips.size()) {
      throw base::CorruptStoredField("tip.front", fmt::format("there is no front {}", tip.front));
    }
  }
}

} // namespace

NamedValueArrays growth_state_to_arrays(const GrowthState& state) {
  StateWriter writer;
  describe(writer, state);
  std::erase_if(writer.arrays, [](const auto& array) { return array.second.empty(); });
  return std::move(writer.arrays);
}

GrowthState growth_state_from_arrays(const NamedValueArrays& arrays) {
  GrowthState state;
  StateReader reader(arrays);
  describe(reader, state);
  reader.finish();
  check_names(state);
  return state;
}

} // namespace spricka::growth
