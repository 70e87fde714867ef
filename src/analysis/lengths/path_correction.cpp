// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/lengths/path_correction.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace spricka::analysis {

namespace {

// Whether K never turns back from one place to the next.
bool monotone(const base::PiecewiseLinear& K, double from, double to) {
  const double way = K(to) - K(from);
  double before = K(from);
  for (const double t : K.knots()) {
    if (t > from && t < to) {
      if ((K(t) - before) * way < 0.0) {
        return false;
      }
      before = K(t);
    }
  }
  return way != 0.0 && (K(to) - before) * way >= 0.0;
}

bool touch_on(const base::PiecewiseLinear& K1, std::size_t segment) {
  return K1.value_at_knot(segment) == 0.0 && K1.slope(segment) == 0.0;
}

using ThreeModes = std::array<double, 3>;

ThreeModes taken_out(const ThreeModes& K, const ThreeModes& raw) {
  return {K[0] - raw[0], K[1] - raw[1], K[2] - raw[2]};
}

// Where on a path the faces of a crack begin to bear, or cease to.
struct FaceOpening {
  double t = 0.0;
  bool open_at_zero = false; ///< the end at which they are open; false: at t = 1
};

// Empty: they do neither before t = 1, or more than once.
std::optional<FaceOpening> find_face_opening(const results::LoadPathResult& path,
                                             const std::string& front) {
  const results::LoadPathContact* faces =
      results::find_contact(path, front.substr(0, front.find('.')) + ".FACES");
  if (faces == nullptr) {
    return std::nullopt;
  }
  std::vector<std::size_t> changes;
  for (std::size_t k = 1; k < faces->closed.size(); ++k) {
    if ((faces->closed[k] > 0) != (faces->closed[k - 1] > 0)) {
      changes.push_back(k);
    }
  }
  return changes.size() == 1 && path.t[changes.front()] < 1.0
             ? std::optional(FaceOpening{path.t[changes.front()], faces->closed.front() == 0})
             : std::nullopt;
}

// Errors that are known at the ends of a path, and where faces begin to bear.
std::vector<ErrorOnPath> errors_on_path(const base::PiecewiseLinear& K, double at_zero,
                                        double at_one, const std::optional<FaceOpening>& faces) {
  std::vector<ErrorOnPath> errors{{0.0, at_zero}, {1.0, at_one}};
  if (faces && faces->t > 0.0 && K.knots().back() >= 1.0) {
    const ErrorOnPath& open = faces->open_at_zero ? errors.front() : errors.back();
    const double ratio = K(open.t) != 0.0 ? K(faces->t) / K(open.t) : 1.0;
    errors.insert(errors.begin() + 1, {faces->t, std::clamp(ratio, -1.0, 1.0) * open.error});
  }
  return errors;
}

void correct_modes(std::array<base::PiecewiseLinear, 3>& K, const ThreeModes& at_zero,
                   const ThreeModes& at_one, const std::optional<FaceOpening>& faces) {
  for (std::size_t mode = 0; mode < K.size(); ++mode) {
    if (at_zero[mode] != 0.0 || at_one[mode] != 0.0) {
      K[mode] = correct_K(K[mode], errors_on_path(K[mode], at_zero[mode], at_one[mode], faces));
    }
  }
}

} // namespace

bool faces_touch_on_path(const base::PiecewiseLinear& K1) {
  for (std::size_t i = 0; i < K1.segment_count(); ++i) {
    if (touch_on(K1, i)) {
      return true;
    }
  }
  return false;
}

base::PiecewiseLinear correct_K(const base::PiecewiseLinear& K,
                                const std::vector<ErrorOnPath>& errors) {
  std::vector<double> value = K.segment_start_values();
  std::vector<double> slope = K.segment_slopes();
  std::size_t segment = 0;
  for (std::size_t e = 0; e + 1 < errors.size(); ++e) {
    const auto [from, error] = errors[e];
    const double to = std::min(errors[e + 1].t, K.knots().back());
    const double change = errors[e + 1].error - error;
    const double way = K(to) - K(from);
    // An error that changes by more than K does is none of K: beyond the ends it would run away.
    const bool by_K = monotone(K, from, to) && std::abs(change) < std::abs(way);
    const double rate = change / (by_K ? way : errors[e + 1].t - from);
    const bool last = e + 2 == errors.size();
    for (; segment < value.size() && (last || K.knots()[segment] < to); ++segment) {
      if (!touch_on(K, segment)) {
        const double t = K.knots()[segment];
        value[segment] += error + rate * (by_K ? K.value_at_knot(segment) - K(from) : t - from);
        slope[segment] += rate * (by_K ? K.slope(segment) : 1.0);
      }
    }
  }
  return {K.knots(), std::move(value), std::move(slope)};
}

void correct_path_K(const results::LoadStepResult& from, const results::LoadStepResult& to,
                    results::LoadPathResult& path) {
  for (std::size_t f = 0; f < path.fronts.size(); ++f) {
    const results::FrontResult& first = from.fronts.at(f);
    const results::FrontResult& last = to.fronts.at(f);
    const std::optional<FaceOpening> faces = find_face_opening(path, first.name);
    for (std::size_t i = 0; i < path.fronts[f].points.size(); ++i) {
      results::LoadPathFrontPoint& point = path.fronts[f].points[i];
      const results::FrontPointResult& low = first.points.at(i);
      const results::FrontPointResult& high = last.points.at(i);
      if (low.raw || high.raw) {
        correct_modes(point.K, taken_out(low.K(), low.raw_K()), taken_out(high.K(), high.raw_K()),
                      faces);
        correct_modes(point.smooth, taken_out(low.smooth, low.raw_smooth_K()),
                      taken_out(high.smooth, high.raw_smooth_K()), faces);
      }
    }
  }
}

} // namespace spricka::analysis
