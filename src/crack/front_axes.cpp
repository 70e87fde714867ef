// SPDX-License-Identifier: GPL-3.0-or-later
#include "crack/front_axes.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include <Eigen/Geometry>

namespace spricka::crack {

using base::Vec3;

namespace {

constexpr std::size_t around = 5; // stations that a derivative is taken from
// Beyond an open end: the turn of the axes between stations [rad], and stations.
constexpr double turn_beyond = 0.05;
constexpr int stations_beyond = 20;

// Stations: the curve's knots, where its places and tangents are best; more between the knots of a
// curve with few.
std::vector<double> stations_along(const mesh::FrontCurve& curve) {
  constexpr std::size_t least = 12;
  std::vector<double> knots;
  for (const Vec3& x : curve.points()) {
    knots.push_back(curve.nearest_length(x));
  }
  knots.front() = 0.0;
  if (curve.closed()) {
    knots.push_back(curve.length());
  } else {
    knots.back() = curve.length();
  }
  const std::size_t pieces = knots.size() - 1;
  const std::size_t parts = (least + pieces - 1) / pieces;
  std::vector<double> s;
  for (std::size_t k = 0; k < pieces; ++k) {
    for (std::size_t i = 0; i < parts; ++i) {
      const double part = static_cast<double>(i) / static_cast<double>(parts);
      s.push_back(knots[k] + part * (knots[k + 1] - knots[k]));
    }
  }
  s.push_back(knots.back());
  return s;
}

// Weights of the derivative at the node `at` of the polynomial through nodes s (Lagrange).
std::array<double, around> slope_weights(const std::array<double, around>& s, std::size_t at) {
  std::array<double, around> weight{};
  for (std::size_t j = 0; j < around; ++j) {
    if (j == at) {
      continue;
    }
    double product = 1.0 / (s[j] - s[at]);
    for (std::size_t k = 0; k < around; ++k) {
      if (k != j && k != at) {
        product *= (s[at] - s[k]) / (s[j] - s[k]);
      }
    }
    weight[j] = product;
    weight[at] -= product;
  }
  return weight;
}

// Hermite's cubic between a station and the next, h farther on; p: part of the way.
template <class Value>
InterpolatedValue<Value> hermite(const Value& from, const Value& to, const Value& d0,
                                 const Value& d1, double h, double p) {
  const Value rise = to - from;
  const Value second = 3.0 * rise - h * (2.0 * d0 + d1);
  const Value third = h * (d0 + d1) - 2.0 * rise;
  return {from + p * (h * d0 + p * (second + p * third)),
          d0 + p / h * (2.0 * second + 3.0 * p * third),
          (2.0 * second + 6.0 * p * third) / (h * h)};
}

} // namespace

// The curve is a cubic: its second derivatives are chords of the true ones, and the third ones go
// up and down by a few per cent of the cube of the curvature, which would mix K2 and K3. So the
// axes at the stations are taken from the curve, and how they turn from one another.
FrontAxes::FrontAxes(const mesh::FrontCurve& curve)
    : s_(stations_along(curve)), closed_(curve.closed()) {
  for (const double s : s_) {
    const mesh::FrontFrame f = curve.at(s);
    axes_.emplace_back() << f.x, f.m, f.b, f.t;
  }
  const auto count = static_cast<std::ptrdiff_t>(s_.size());
  const std::ptrdiff_t period = count - 1;
  for (std::ptrdiff_t i = 0; i < count; ++i) {
    const std::ptrdiff_t first = closed_ ? i - 2 : std::clamp<std::ptrdiff_t>(i - 2, 0, count - 5);
    std::array<double, around> s{};
    std::array<std::size_t, around> from{};
    for (std::size_t k = 0; k < around; ++k) {
      const std::ptrdiff_t j = first + static_cast<std::ptrdiff_t>(k);
      const std::ptrdiff_t in = closed_ ? (j + period) % period : j;
      const std::ptrdiff_t rounds = closed_ ? (j - in) / period : 0;
      from[k] = static_cast<std::size_t>(in);
      s[k] = s_[from[k]] + static_cast<double>(rounds) * s_.back();
    }
    const auto weight = slope_weights(s, static_cast<std::size_t>(i - first));
    Axes& turn = turn_.emplace_back(Axes::Zero());
    for (std::size_t k = 0; k < around; ++k) {
      turn += weight[k] * axes_[from[k]];
    }
    turn.col(0) = axes_[static_cast<std::size_t>(i)].col(3); // dx/ds
  }
  if (!closed_) {
    go_on_beyond_ends();
  }
}

// Axes turn about one line at one rate, places lie on a helix about it.
void FrontAxes::go_on_beyond_ends() {
  for (const bool last : {false, true}) {
    const std::size_t end = last ? s_.size() - 1 : 0;
    const Axes at = axes_[end];
    const Axes turn = turn_[end];
    const double s = s_[end];
    Vec3 rate = Vec3::Zero();
    for (Eigen::Index k = 1; k < 4; ++k) {
      rate += 0.5 * at.col(k).cross(turn.col(k));
    }
    const double size = rate.norm();
    const double apart = std::min(turn_beyond / std::max(size, turn_beyond / s_.back()),
                                  s_.back() / stations_beyond);
    const Vec3 line = size > 0.0 ? Vec3(rate / size) : Vec3::UnitX();
    const Vec3 t = at.col(3);
    for (int k = 1; k <= stations_beyond; ++k) {
      const double way = (last ? k : -k) * apart;
      const double angle = size * way;
      const Eigen::Matrix3d R = Eigen::AngleAxisd(angle, line).toRotationMatrix();
      Axes there = R * at;
      there.col(0) = at.col(0) + way * t;
      if (std::abs(angle) > 1e-6) { // the integral of the turned t
        there.col(0) += (1.0 - std::cos(angle)) / size * line.cross(t) +
                        (way - std::sin(angle) / size) * line.cross(line.cross(t));
      }
      Axes turned = R * turn;
      turned.col(0) = there.col(3);
      const auto place = [&](auto& list) { return last ? list.end() : list.begin(); };
      s_.insert(place(s_), s + way);
      axes_.insert(place(axes_), there);
      turn_.insert(place(turn_), turned);
    }
  }
}

std::size_t FrontAxes::nearest_station(const Vec3& x) const {
  std::size_t station = 0;
  double least = std::numeric_limits<double>::max();
  for (std::size_t i = 0; i < s_.size(); ++i) {
    const double away = (axes_[i].col(0) - x).squaredNorm();
    if (away < least) {
      least = away;
      station = i;
    }
  }
  return station;
}

InterpolatedValue<FrontAxes::Axes> FrontAxes::turned(std::size_t i, double part) const {
  return hermite(axes_[i], axes_[i + 1], turn_[i], turn_[i + 1], s_[i + 1] - s_[i], part);
}

InterpolatedValue<Vec3> FrontAxes::point(std::size_t i, double part) const {
  return hermite<Vec3>(axes_[i].col(0), axes_[i + 1].col(0), turn_[i].col(0), turn_[i + 1].col(0),
                       s_[i + 1] - s_[i], part);
}

FrontCoordinates FrontAxes::locate_point(const Vec3& x, UpperOrLowerFace side) const {
  const std::size_t last = s_.size() - 2; // of the intervals
  std::size_t i = std::min(nearest_station(x), last);
  double part = 0.0;
  InterpolatedValue<Vec3> on = point(i, part);
  double beyond = 0.0; // an open end, along its tangent
  // Newton's steps for d . t = 0, across stations where they lead there.
  for (int step = 0; step < 20; ++step) {
    const Vec3 d = x - on.at;
    const Vec3& t = on.by_s;
    const double full = t.squaredNorm() - d.dot(on.by_ss);
    const double way = d.dot(t) / (full > 0.1 ? full : t.squaredNorm());
    double s = s_[i] + part * (s_[i + 1] - s_[i]) + way;
    if (closed_) {
      const double whole = s_.back();
      s -= whole * std::floor(s / whole);
    }
    beyond = s < s_.front() ? s - s_.front() : std::max(0.0, s - s_.back());
    s = std::clamp(s, s_.front(), s_.back());
    while (i > 0 && s < s_[i]) {
      --i;
    }
    while (i < last && s > s_[i + 1]) {
      ++i;
    }
    if (closed_ && (s < s_[i] || s > s_[i + 1])) { // over the end of the round
      i = s > s_[i + 1] ? last : 0;
    }
    part = (s - s_[i]) / (s_[i + 1] - s_[i]);
    on = point(i, part);
    if (std::abs(way) < 1e-13 * s_.back() || (!closed_ && beyond != 0.0 && step > 0)) {
      break;
    }
  }
  const InterpolatedValue<Axes> f = turned(i, part);
  FrontCoordinates place;
  mesh::FrontFrame& frame = place.frame;
  frame.s = s_[i] + part * (s_[i + 1] - s_[i]);
  frame.x = f.at.col(0);
  frame.m = f.at.col(1);
  frame.b = f.at.col(2);
  frame.t = f.at.col(3);
  // Round-off takes no point of the body's surface at an end to where the front does not turn.
  const bool outside = !closed_ && std::abs(beyond) > 1e-9 * s_.back();
  if (outside) { // straight on
    const double away = (x - frame.x).dot(frame.t);
    frame.s += away;
    frame.x += away * frame.t;
  } else {
    frame.dm = f.by_s.col(1);
    frame.db = f.by_s.col(2);
    frame.dt = f.by_s.col(3);
    place.ddm = f.by_ss.col(1);
    place.ddb = f.by_ss.col(2);
    place.ddt = f.by_ss.col(3);
  }
  const Vec3 d = x - frame.x;
  place.y = d.dot(frame.m);
  place.z = d.dot(frame.b);
  place.r = std::hypot(place.y, place.z);
  place.theta = std::atan2(place.z, place.y);
  if (side != UpperOrLowerFace::none) {
    // Edges on the front are parabolas: where its curvature changes they pass it by some
    // thousandths of a radius, and points of a face beside it may lie ahead of the curve, where the
    // auxiliary fields' stress has no bound.
    place.theta = side == UpperOrLowerFace::upper ? std::numbers::pi : -std::numbers::pi;
  }
  return place;
}

} // namespace spricka::crack
