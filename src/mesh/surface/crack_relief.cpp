// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/surface/crack_relief.hpp"

#include "geometry/polyline.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <utility>

#include <Eigen/Geometry>

namespace spricka::mesh {

namespace {

using base::Vec3;

// A closed line begun anew at the point nearest to x.
void begin_at(const Vec3& x, std::vector<Vec3>& line) {
  line.pop_back();
  const auto nearest =
      std::ranges::min_element(line, {}, [&](const Vec3& p) { return (p - x).squaredNorm(); });
  std::rotate(line.begin(), nearest, line.end());
  line.push_back(line.front());
}

} // namespace

NonPlanarCrackSurface::NonPlanarCrackSurface(PastAndPresentFronts fronts)
    : fronts_(std::move(fronts)) {
  const std::vector<std::vector<Vec3>>& lines = fronts_.points;
  assert(lines.size() >= 2 && fronts_.normals.size() == lines.back().size());
  for (const std::vector<Vec3>& line : lines) {
    box_.extend(geometry::Box<3>::around(line));
  }
  narrowest_ = box_.diagonal();
  for (std::size_t k = 1; k < lines.size(); ++k) {
    double widest = 0.0;
    for (const Vec3& x : lines[k]) {
      widest = std::max(widest, geometry::nearest_point(x, lines[k - 1]).distance);
    }
    narrowest_ = std::min(narrowest_, widest);
    rule(lines[k - 1], lines[k]);
    ++number_;
  }
  go_on_before();
  tree_ = geometry::TriangleTree(flat_);
  find_bends();
}

void NonPlanarCrackSurface::add(const Vec3& a, const Vec3& b, const Vec3& c) {
  constexpr double no_area = 1e-12;
  const Vec3& n = fronts_.normal;
  const Vec3 e1 = flat(b - a);
  const Vec3 e2 = flat(c - a);
  const double area = n.dot(e1.cross(e2));
  if (std::abs(area) <= no_area * (box_.high - box_.low).squaredNorm()) {
    return;
  }
  const Vec3 slope = (n.dot(b - a) * e2.cross(n) + n.dot(c - a) * n.cross(e1)) / area;
  strips_.push_back({a, slope, number_});
  flat_.push_back({flat(a), flat(b), flat(c)});
}

// Triangles between two lines, each time with the shorter of both diagonals.
void NonPlanarCrackSurface::rule(std::vector<Vec3> a, std::vector<Vec3> b) {
  if (a.front() == a.back()) {
    begin_at(b.front(), a);
  } else if (b.front() == b.back()) {
    begin_at(a.front(), b);
  }
  std::size_t i = 0;
  std::size_t j = 0;
  while (i + 1 < a.size() || j + 1 < b.size()) {
    const bool by_a =
        j + 1 == b.size() ||
        (i + 1 < a.size() && (a[i + 1] - b[j]).squaredNorm() < (a[i] - b[j + 1]).squaredNorm());
    add(a[i], b[j], by_a ? a[i + 1] : b[j + 1]);
    ++(by_a ? i : j);
  }
}

void NonPlanarCrackSurface::go_on_before() {
  const std::vector<Vec3>& line = fronts_.points.back();
  const double far = box_.diagonal();
  std::vector<Vec3> ahead;
  for (std::size_t i = 0; i < line.size(); ++i) {
    ahead.emplace_back(
        line[i] +
        far * fronts_.normals[i].cross(geometry::polyline_direction_at(line, i)).normalized());
  }
  for (std::size_t i = 0; i + 1 < line.size(); ++i) {
    add(line[i], ahead[i], ahead[i + 1]);
    add(line[i], ahead[i + 1], line[i + 1]);
  }
}

// By the slopes on both sides of a front.
void NonPlanarCrackSurface::find_bends() {
  constexpr double beside = 0.02; // of the narrowest strip
  for (std::size_t k = 0; k + 1 < fronts_.points.size(); ++k) {
    const std::vector<Vec3>& line = fronts_.points[k];
    std::vector<double>& turned = turned_.emplace_back();
    for (std::size_t i = 0; i < line.size(); ++i) {
      const Vec3 m =
          fronts_.normal.cross(flat(geometry::polyline_direction_at(line, i))).normalized();
      const Vec3 before = fronts_.normal - crack_height_gradient(line[i] - beside * narrowest_ * m);
      const Vec3 behind = fronts_.normal - crack_height_gradient(line[i] + beside * narrowest_ * m);
      turned.push_back(std::atan2(before.cross(behind).norm(), before.dot(behind)));
    }
  }
}

bool NonPlanarCrackSurface::behind_first(const Vec3& q) const {
  const std::vector<Vec3>& line = fronts_.points.front();
  const Vec3 in_plane = q + fronts_.normal.dot(line.front()) * fronts_.normal;
  const geometry::NearestPolylinePoint on = geometry::nearest_point(in_plane, line);
  const std::size_t corner = on.part < 0.5 ? on.piece : on.piece + 1;
  const bool at_corner = on.part == 0.0 || on.part == 1.0;
  const Vec3 t = at_corner ? geometry::polyline_direction_at(line, corner)
                           : Vec3((line[on.piece + 1] - line[on.piece]).normalized());
  return (q - flat(on.interpolate(line))).dot(fronts_.normal.cross(t)) <= 0.0;
}

double NonPlanarCrackSurface::crack_height_over_plane(const Vec3& x) const {
  const Vec3& n = fronts_.normal;
  const Vec3 q = flat(x);
  if (behind_first(q)) {
    return n.dot(fronts_.points.front().front() - x);
  }
  const geometry::TriangleTree::NearestTriangle at = tree_.nearest(q);
  const StripTriangle& strip = strips_[at.given];
  return n.dot(strip.x0 - x) + strip.slope.dot(at.at - strip.x0);
}

Vec3 NonPlanarCrackSurface::crack_height_gradient(const Vec3& x) const {
  const Vec3 q = flat(x);
  return behind_first(q) ? Vec3::Zero() : strips_[tree_.nearest(q).given].slope;
}

Vec3 NonPlanarCrackSurface::normal_at_front(const Vec3& x) const {
  const std::vector<Vec3>& line = fronts_.points.back();
  return geometry::nearest_point(x, line).interpolate(fronts_.normals).normalized();
}

double NonPlanarCrackSurface::distance_to_kink(const Vec3& x, double angle) const {
  double least = std::numeric_limits<double>::max();
  for (std::size_t k = 0; k < turned_.size(); ++k) {
    for (std::size_t i = 0; i < turned_[k].size(); ++i) {
      if (turned_[k][i] > angle) {
        least = std::min(least, (fronts_.points[k][i] - x).norm());
      }
    }
  }
  return least;
}

std::vector<std::vector<Vec3>> NonPlanarCrackSurface::kink_lines(double angle) const {
  std::vector<std::vector<Vec3>> all;
  for (std::size_t k = 0; k < turned_.size(); ++k) {
    const std::vector<Vec3>& line = fronts_.points[k];
    const std::vector<double>& turned = turned_[k];
    const auto straight =
        std::ranges::find_if(turned, [&](double turn) { return turn <= angle; }) - turned.begin();
    if (straight == std::ssize(turned)) {
      all.push_back(line);
      continue;
    }
    // All round a closed one from where it is straight.
    const bool closed = line.front() == line.back();
    const std::size_t count = closed ? line.size() - 1 : line.size();
    const std::size_t begin = closed ? static_cast<std::size_t>(straight) : 0;
    std::vector<Vec3> run;
    for (std::size_t n = 0; n <= count; ++n) {
      const std::size_t i = (begin + n) % count;
      if (n < count && turned[i] > angle) {
        run.push_back(line[i]);
        continue;
      }
      if (run.size() > 1) {
        all.push_back(std::move(run));
      }
      run.clear();
    }
  }
  return all;
}

std::size_t NonPlanarCrackSurface::strip_number(const Vec3& x) const {
  const Vec3 q = flat(x);
  return behind_first(q) ? 0 : strips_[tree_.nearest(q).given].number;
}

NonPlanarCrackSurface NonPlanarCrackSurface::transformed(const Map& place,
                                                         const Map& direction) const {
  PastAndPresentFronts made;
  made.normal = direction(fronts_.normal);
  for (const std::vector<Vec3>& line : fronts_.points) {
    std::vector<Vec3>& there = made.points.emplace_back();
    std::ranges::transform(line, std::back_inserter(there), place);
  }
  std::ranges::transform(fronts_.normals, std::back_inserter(made.normals), direction);
  return NonPlanarCrackSurface(std::move(made));
}

} // namespace spricka::mesh
