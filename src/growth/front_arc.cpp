// SPDX-License-Identifier: GPL-3.0-or-later
#include "growth/front_arc.hpp"

#include "growth/turned_front.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <utility>

#include <Eigen/Geometry>

namespace spricka::growth {

namespace {

using base::Vec3;

constexpr int looks_along = 240;     // places of a front that are looked at: in the body or not
constexpr int points_of_front = 120; // of a front that is handed on: a spline through them
constexpr int steps_out = 60;        // out of the body, each a fiftieth of the arc
constexpr double step_out = 0.02;
constexpr double still_apart = 0.25; // of two points before they went on

// All of the front as the deck or an advance drew it, m out of the crack.
mesh::FrontCurve whole_front(const model::CrackDefinition& crack) {
  std::vector<Vec3> points = crack.points;
  const model::PlanarCrack& plane = crack.plane;
  const bool ellipse = crack.kind == model::CrackDefinitionKind::ellipse;
  if (ellipse) {
    points.clear();
    for (int i = 0; i < looks_along; ++i) {
      points.push_back(plane.ellipse_point(-2.0 * std::numbers::pi * i / looks_along));
    }
  }
  const bool closed = ellipse || plane.closed;
  mesh::FrontCurve curve(points, crack_normals(crack, points), closed);
  double outwards = 0.0;
  for (const Vec3& x : points) {
    outwards += curve.at(curve.nearest_length(x)).m.dot(x - plane.place);
  }
  if (outwards < 0.0) {
    std::ranges::reverse(points);
    curve = mesh::FrontCurve(points, crack_normals(crack, points), closed);
  }
  return curve;
}

// Places of a front one after another that lie in the body, the first and the last.
struct InsideRange {
  int begin = 0, last = 0;
};

// All runs there are; of a closed front one may go on over its end.
std::vector<InsideRange> runs_of(const std::vector<bool>& in, bool closed) {
  const int n = static_cast<int>(in.size());
  const auto is_in = [&](int i) { return in[static_cast<std::size_t>((i + n) % n)]; };
  std::vector<InsideRange> runs;
  for (int i = 0; i < n; ++i) {
    if (!is_in(i) || (i == 0 ? closed && is_in(-1) : is_in(i - 1))) {
      continue;
    }
    InsideRange run{i, i};
    if (closed && i == 0) { // lengths along it count up from 0
      run = {n, n};
    }
    while (run.last + 1 < (closed ? 2 * n : n) && is_in(run.last + 1)) {
      ++run.last;
    }
    runs.push_back(run);
  }
  return runs;
}

} // namespace

base::Vec3 BodyFrontArc::nearest(const base::Vec3& x) const {
  const double s = curve.nearest_length(x); // of an open curve beyond its ends, too
  return curve.at(is_closed() ? s : std::clamp(s, 0.0, curve.length())).x;
}

double BodyFrontArc::arc_position(double number, std::size_t count) const {
  const std::size_t parts = is_closed() ? count : count - 1;
  return curve.length() * number / static_cast<double>(parts);
}

std::vector<BodyFrontArc> front_arcs_in_body(const model::CrackDefinition& crack,
                                             const SolidBodyQuery& around) {
  const mesh::FrontCurve whole = whole_front(crack);
  const bool closed = whole.closed();
  const int n = closed ? looks_along : looks_along + 1;
  const auto s_of = [&](int i) { return whole.length() * i / looks_along; };
  const auto in_body = [&](double s) { return around.inside(whole.at(s).x, crack.net); };
  std::vector<bool> in;
  in.reserve(static_cast<std::size_t>(n));
  for (int i = 0; i < n; ++i) {
    in.push_back(in_body(s_of(i)));
  }
  std::vector<BodyFrontArc> arcs;
  if (std::ranges::all_of(in, [](bool inside) { return inside; })) {
    arcs.push_back({whole});
    return arcs;
  }
  // Where it comes out, between a place inside and the next one outside.
  const auto border = [&](double inside, double outside) {
    for (int k = 0; k < 50; ++k) {
      const double middle = 0.5 * (inside + outside);
      (in_body(middle) ? inside : outside) = middle;
    }
    return inside;
  };
  for (const InsideRange& run : runs_of(in, closed)) {
    const bool from_end = !closed && run.begin == 0;
    const bool to_end = !closed && run.last == n - 1;
    const double s0 = from_end ? 0.0 : border(s_of(run.begin), s_of(run.begin - 1));
    const double s1 = to_end ? whole.length() : border(s_of(run.last), s_of(run.last + 1));
    std::vector<Vec3> points;
    for (int i = 0; i <= points_of_front; ++i) {
      points.push_back(whole.at(s0 + (s1 - s0) * i / points_of_front).x);
    }
    std::vector<Vec3> normals = crack_normals(crack, points);
    arcs.push_back({mesh::FrontCurve(std::move(points), std::move(normals), false)});
  }
  return arcs;
}

std::optional<BodyFrontArc> single_front_arc_in_body(const model::CrackDefinition& crack,
                                                     const SolidBodyQuery& around) {
  std::vector<BodyFrontArc> arcs = front_arcs_in_body(crack, around);
  return arcs.size() == 1 ? std::optional(std::move(arcs.front())) : std::nullopt;
}

std::optional<model::CrackDefinition>
make_crack_through_points(const model::CrackDefinition& before, const std::vector<Vec3>& points,
                          bool closed, const SolidBodyQuery& around) {
  const mesh::FrontCurve curve(points, crack_normals(before, points), closed);
  model::CrackDefinition crack = before;
  crack.kind = model::CrackDefinitionKind::drawn;
  crack.plane.closed = closed;
  crack.points.clear();
  for (int i = 0; i < points_of_front + (closed ? 0 : 1); ++i) {
    crack.points.push_back(curve.at(curve.length() * i / points_of_front).x);
  }
  if (closed) {
    return crack;
  }
  const double h = step_out * curve.length();
  for (const bool at_last : {false, true}) {
    const mesh::FrontFrame end = curve.at(at_last ? curve.length() : 0.0);
    const Vec3 way = at_last ? end.t : Vec3(-end.t);
    int outside = 0;
    for (int k = 1; k <= steps_out && outside < 2; ++k) {
      const Vec3 x = end.x + k * h * way;
      outside += around.inside(x, crack.net) ? -outside : 1;
      crack.points.insert(at_last ? crack.points.end() : crack.points.begin(), x);
    }
    if (outside < 2) {
      return std::nullopt;
    }
  }
  return crack;
}

std::vector<Vec3> drop_crossing_points(const std::vector<mesh::FrontFrame>& from,
                                       const std::vector<Vec3>& to, bool closed) {
  std::vector<std::size_t> kept(from.size());
  std::iota(kept.begin(), kept.end(), std::size_t{0});
  for (bool more = true; more && kept.size() > fewest_front_points;) {
    const std::size_t n = kept.size();
    std::vector<bool> crosses(n, false);
    // Of the two sides of a notch neither may pass the point between them.
    for (std::size_t k = 0; k < 2 * n; ++k) {
      const std::size_t first = k % n;
      const std::size_t last = first + 1 + k / n;
      const Vec3 apart = from[kept[last % n]].x - from[kept[first]].x;
      const Vec3 behind = to[kept[last % n]] - to[kept[first]];
      if ((closed || last < n) && behind.dot(apart) < still_apart * apart.squaredNorm()) {
        crosses[first] = crosses[last % n] = true;
      }
    }
    if (!closed) {
      crosses.front() = crosses.back() = false;
    }
    std::vector<std::size_t> next;
    for (std::size_t k = 0; k < n; ++k) {
      if (!crosses[k]) {
        next.push_back(kept[k]);
      }
    }
    more = next.size() < n;
    kept = std::move(next);
  }
  std::vector<Vec3> points;
  points.reserve(kept.size());
  for (const std::size_t i : kept) {
    points.push_back(to[i]);
  }
  return points;
}

} // namespace spricka::growth
