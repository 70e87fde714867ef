// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/lengths/place_on_front.hpp"

#include "crack/k_layout.hpp"
#include "geometry/polyline.hpp"

#include <algorithm>
#include <utility>

namespace spricka::analysis {

namespace {

// Records of steps and of load paths, read alike.
const results::FrontResult& record_of(const results::FrontResult& front) {
  return front;
}
const results::FrontResult& record_of(const results::LoadPathFront& front) {
  return front.front_without_points;
}
const results::FrontPointResult& record_of(const results::FrontPointResult& point) {
  return point;
}
const results::FrontPointResult& record_of(const results::LoadPathFrontPoint& point) {
  return point.point_at_start;
}

// No name: of any.
bool is_of(const std::string& front, const std::string& crack) {
  return crack.empty() || front == crack || front.starts_with(crack + ".");
}

template <class Front>
PlaceOnFront nearest_of(const std::vector<Front>& fronts, const std::string& name,
                        const base::Vec3& x) {
  PlaceOnFront best;
  for (std::size_t f = 0; f < fronts.size(); ++f) {
    const results::FrontResult& is = record_of(fronts[f]);
    const std::size_t n = fronts[f].points.size();
    if (!(n == 1 && !name.empty() ? is.name == name : is_of(is.name, name))) {
      continue;
    }
    if (n == 1 && best.away > (record_of(fronts[f].points[0]).x - x).norm()) {
      best = {.front = f, .away = (record_of(fronts[f].points[0]).x - x).norm()};
    }
    for (std::size_t i = 0; i + (is.is_loop ? 0 : 1) < n; ++i) {
      const std::size_t j = (i + 1) % n;
      const auto [part, away] = geometry::nearest_point(x, record_of(fronts[f].points[i]).x,
                                                        record_of(fronts[f].points[j]).x);
      if (away < best.away) {
        best = {.front = f, .from = i, .to = j, .part = part, .away = away};
      }
    }
  }
  return best;
}

/// What of a front's point counts at a place.
struct PointWeight {
  std::size_t point = 0;
  double weight = 0.0;
};

// The cubic through the four points about a place, as K along a front bends between two of them; a
// line where the faces touch at one of them.
template <class Front>
std::vector<PointWeight> weights_at(const Front& front, const PlaceOnFront& at) {
  constexpr std::size_t four = 4;
  const results::FrontResult& is = record_of(front);
  const std::size_t count = front.points.size();
  const auto s_of = [&](std::size_t i) { return record_of(front.points[i]).s; };
  if (count == 1) {
    return {{0, 1.0}};
  }
  std::vector<PointWeight> found{{at.from, 1.0 - at.part}, {at.to, at.part}};
  if (count < four) {
    return found;
  }
  // From the one before the two on; at an open end the first or the last four.
  const std::size_t first = is.is_loop
                                ? (at.from + count - 1) % count
                                : std::min(std::max<std::size_t>(at.from, 1) - 1, count - four);
  std::vector<double> s;
  std::vector<PointWeight> all;
  double place = 0.0;
  for (std::size_t k = first; k < first + four; ++k) {
    const std::size_t i = k % count;
    const double round = k < count ? 0.0 : is.length;
    s.push_back(s_of(i) + round);
    all.push_back({i, 1.0});
    // On a path K bends by t where faces touch under a load: no cubic.
    if (record_of(front.points[i]).closed) {
      return found;
    }
    if (i == at.from) {
      const std::size_t next = (i + 1) % count;
      const double after = s_of(next) + (next == 0 ? is.length : 0.0) - s_of(i);
      place = s.back() + at.part * after;
    }
  }
  for (std::size_t k = 0; k < four; ++k) {
    for (std::size_t j = 0; j < four; ++j) {
      all[k].weight *= j == k ? 1.0 : (place - s[j]) / (s[k] - s[j]);
    }
  }
  return all;
}

} // namespace

PlaceOnFront nearest_place(const std::vector<results::FrontResult>& fronts, const std::string& name,
                           const base::Vec3& x) {
  return nearest_of(fronts, name, x);
}

PlaceOnFront nearest_place(const std::vector<results::LoadPathFront>& fronts,
                           const std::string& name, const base::Vec3& x) {
  return nearest_of(fronts, name, x);
}

bool is_part_through(const results::FrontResult& front) {
  const std::vector<results::FrontPointResult>& points = front.points;
  if (front.is_loop || points.size() < 3) {
    return front.is_loop;
  }
  const base::Vec3 first = (points[1].x - points[0].x).normalized();
  const base::Vec3 last = (points.back().x - points[points.size() - 2].x).normalized();
  return first.dot(last) < std::sqrt(0.5);
}

base::Vec3 point_on_front_curve(const results::FrontResult& front, const PlaceOnFront& at) {
  base::Vec3 x = base::Vec3::Zero();
  for (const auto& [i, weight] : weights_at(front, at)) {
    x += weight * front.points[i].x;
  }
  return x;
}

base::Vec3 interpolate_smooth_K(const results::FrontResult& front, const PlaceOnFront& at) {
  base::Vec3 K = base::Vec3::Zero();
  for (const auto& [i, weight] : weights_at(front, at)) {
    K += weight * base::Vec3::Map(front.points[i].smooth.data());
  }
  return K;
}

base::PiecewiseLinear combined_K_over_path(const results::LoadPathFront& front,
                                           const PlaceOnFront& at, const base::Vec2& part) {
  const base::PiecewiseLinear& from = front.points[at.from].smooth[0];
  std::vector<double> value(from.segment_count(), 0.0);
  std::vector<double> slope(from.segment_count(), 0.0);
  for (const auto& [i, weight] : weights_at(front, at)) {
    for (std::size_t mode = 0; mode < 2; ++mode) {
      const double share = weight * part[static_cast<Eigen::Index>(mode)];
      const base::PiecewiseLinear& K = front.points[i].smooth[mode];
      for (std::size_t k = 0; k < value.size() && share != 0.0; ++k) {
        value[k] += share * K.value_at_knot(k);
        slope[k] += share * K.slope(k);
      }
    }
  }
  return {from.knots(), std::move(value), std::move(slope)};
}

std::function<double(const base::Vector&)>
make_K_interpolator(const results::LoadStepResult& step, const PlaceOnFront& place, int mode) {
  std::size_t first = 0; // of the front's points
  std::size_t points = 0;
  for (std::size_t f = 0; f < step.fronts.size(); ++f) {
    first += f < place.front ? step.fronts[f].points.size() : 0;
    points += step.fronts[f].points.size();
  }
  std::vector<PointWeight> weights = weights_at(step.fronts[place.front], place);
  return [first, points, mode, weights = std::move(weights)](const base::Vector& K) {
    const crack::KLayout layout(points, static_cast<int>(K.size()) / static_cast<int>(points));
    double at = 0.0;
    for (const auto& [point, weight] : weights) {
      at += weight * K[layout.at(first + point, mode)];
    }
    return at;
  };
}

std::optional<base::PiecewiseLinear> path_K1_at_nearest_place(const results::LoadPathResult& path,
                                                              const base::Vec3& x) {
  const PlaceOnFront place = nearest_place(path.fronts, "", x);
  return place.found()
             ? std::optional(combined_K_over_path(path.fronts[place.front], place, {1.0, 0.0}))
             : std::nullopt;
}

} // namespace spricka::analysis
