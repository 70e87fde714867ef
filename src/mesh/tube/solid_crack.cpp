// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/tube/solid_crack.hpp"

#include "geometry/polyline.hpp"
#include "mesh/front_curve.hpp"
#include "mesh/plane.hpp"
#include "mesh/surface/crack_relief.hpp"
#include "model/model.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include <Eigen/Geometry>

namespace spricka::mesh {

using base::Vec2;
using base::Vec3;

std::vector<Vec3> SolidCrack::normals_at(const std::vector<Vec3>& points) const {
  std::vector<Vec3> normals(points.size(), normal);
  if (relief) {
    std::ranges::transform(points, normals.begin(),
                           [&](const Vec3& x) { return relief->normal_at_front(x); });
  }
  return normals;
}

std::string SolidCrack::display_name() const {
  return "crack " + (name.empty() ? std::to_string(crack.index() + 1) : name);
}

std::shared_ptr<const NonPlanarCrackSurface>
nonplanar_crack_surface_in_frame(const CrackFrame& frame, const SolidCrack& crack) {
  if (!crack.relief) {
    return nullptr;
  }
  return std::make_shared<const NonPlanarCrackSurface>(
      crack.relief->transformed([&](const Vec3& x) { return frame.exact_local_coordinates(x); },
                                [&](const Vec3& d) -> Vec3 { return frame.axes.transpose() * d; }));
}

CrackFrame make_crack_frame(const SolidCrack& crack) {
  const std::vector<Vec3>& x = crack.front;
  const double length = geometry::polyline_length(x);
  // Fan of triangles from the first point: area and middle of what the front encloses.
  double area = 0.0;
  Vec3 moment = Vec3::Zero();
  for (std::size_t i = 1; i + 1 < x.size(); ++i) {
    const double part = 0.5 * (x[i] - x[0]).cross(x[i + 1] - x[0]).dot(crack.normal);
    area += part;
    moment += part / 3.0 * (x[i] + x[i + 1] - 2.0 * x[0]);
  }
  CrackFrame frame;
  const double radius = std::sqrt(std::abs(area) / std::numbers::pi);
  const bool thin = radius < 0.02 * length; // of a straight front
  frame.a = thin ? 0.25 * length : radius;
  frame.origin = thin ? Vec3(0.5 * (x.front() + x.back())) : Vec3(x[0] + moment / area);
  const Vec3 ahead = x[0] - frame.origin;
  const Vec3 e1 = (ahead - crack.normal.dot(ahead) * crack.normal).normalized();
  frame.axes.col(0) = e1;
  frame.axes.col(1) = crack.normal.cross(e1);
  frame.axes.col(2) = crack.normal;
  return frame;
}

namespace {

constexpr double apart = 0.5; // radii of the tube
constexpr std::size_t fewest = 4;

bool is_closed(const CrackFront& front) {
  return front.points.size() > 1 && !front.points.front().at_surface;
}

// Points from one end to the middle, the end first.
std::vector<Vec3> spaced_from(const CrackFront& front, bool last) {
  const std::size_t count = front.points.size();
  const auto at = [&](std::size_t i) -> const FrontPoint& {
    return front.points[last ? count - 1 - i : i];
  };
  std::vector<Vec3> kept{at(0).x};
  for (std::size_t i = 1; i < count / 2; ++i) {
    if ((at(i).x - kept.back()).norm() >= apart * at(i).radius) {
      kept.push_back(at(i).x);
    }
  }
  return kept;
}

// Alike from both ends, so that mirrored fronts have mirrored curves.
std::vector<Vec3> spaced_points(const CrackFront& front) {
  std::vector<Vec3> points = spaced_from(front, false);
  const std::vector<Vec3> others = spaced_from(front, true);
  if (front.points.size() % 2 != 0) {
    points.push_back(front.points[front.points.size() / 2].x);
  }
  points.insert(points.end(), others.rbegin(), others.rend());
  return points;
}

/// Weights of the points of a front: the lengths below their linear hats, from their s.
void compute_front_point_weights(bool closed, CrackFront& front) {
  const std::size_t n = front.points.size();
  for (FrontPoint& point : front.points) {
    point.weight = 0.0;
  }
  for (std::size_t k = 0; k < (closed ? n : n - 1); ++k) {
    const std::size_t next = (k + 1) % n;
    const double end = next == 0 ? front.curve->length() : front.points[next].s;
    const double half = 0.5 * (end - front.points[k].s);
    front.points[k].weight += half;
    front.points[next].weight += half;
  }
}

} // namespace

std::shared_ptr<const FrontCurve> fit_front_curve(const CrackFront& front,
                                                  const SolidCrack& crack) {
  std::vector<Vec3> points;
  std::ranges::transform(front.points, std::back_inserter(points), &FrontPoint::x);
  if (!is_closed(front)) {
    std::vector<Vec3> spaced = spaced_points(front);
    if (spaced.size() >= fewest) {
      points = std::move(spaced);
    }
  }
  std::vector<Vec3> normals = crack.normals_at(points);
  return std::make_shared<const FrontCurve>(std::move(points), std::move(normals),
                                            is_closed(front));
}

void recompute_front_point_geometry(const model::Mesh& mesh, CrackFront& front) {
  const bool closed = is_closed(front);
  double first = 0.0;
  for (std::size_t k = 0; k < front.points.size(); ++k) {
    FrontPoint& point = front.points[k];
    point.x = mesh.x[point.node.index()];
    const double s = front.curve->nearest_length(point.x);
    point.growth = front.curve->at(s).m;
    first = k == 0 ? s : first;
    point.s = s - first;
    point.s += closed && point.s < 0.0 ? front.curve->length() : 0.0;
  }
  compute_front_point_weights(closed, front);
}

namespace {

constexpr int ellipse_points = 360; // a spline through them is exact to 1e-9 of the axes

// t = m x b with m outwards: clockwise, seen from where the normal points to.
std::vector<Vec3> ellipse_front(const model::PlanarCrack& plane) {
  std::vector<Vec3> front;
  front.reserve(ellipse_points);
  for (int i = 0; i < ellipse_points; ++i) {
    front.push_back(plane.ellipse_point(-2.0 * std::numbers::pi * i / ellipse_points));
  }
  return front;
}

// Points as drawn, or the other way round where m would point into the crack.
std::vector<Vec3> drawn_front(const model::CrackDefinition& crack) {
  std::vector<Vec3> front = crack.points;
  const model::PlanarCrack& plane = crack.plane;
  bool inwards = false;
  if (plane.closed) {
    Vec3 area = Vec3::Zero();
    for (std::size_t i = 0; i < front.size(); ++i) {
      area += (front[i] - front[0]).cross(front[(i + 1) % front.size()] - front[0]);
    }
    inwards = area.dot(plane.normal) > 0.0;
  } else {
    const FrontCurve curve(front, std::vector<Vec3>(front.size(), plane.normal), false);
    const FrontFrame near = curve.at(curve.nearest_length(plane.place));
    inwards = near.m.dot(plane.place - near.x) > 0.0;
  }
  if (inwards) {
    std::ranges::reverse(front);
  }
  return front;
}

} // namespace

std::vector<SolidCrack> make_solid_cracks(const model::Model& model) {
  std::vector<SolidCrack> cracks;
  for (std::size_t i = 0; i < model.cracks.size(); ++i) {
    const model::CrackDefinition& crack = model.cracks[i];
    const bool gone = crack.kind == model::CrackDefinitionKind::drawn && crack.points.empty();
    if (crack.kind == model::CrackDefinitionKind::front || gone) {
      continue; // in the mesh already, or become a part of another one as it grew
    }
    const bool ellipse = crack.kind == model::CrackDefinitionKind::ellipse;
    SolidCrack cut;
    cut.crack = base::CrackId(i);
    cut.net = crack.net;
    cut.normal = crack.plane.normal;
    cut.front = ellipse ? ellipse_front(crack.plane) : drawn_front(crack);
    if (ellipse) {
      cut.middle = crack.plane.place;
    }
    cut.closed = ellipse || crack.plane.closed;
    cut.name = crack.name;
    if (!crack.front_history.fronts.empty()) {
      cut.relief =
          std::make_shared<const NonPlanarCrackSurface>(NonPlanarCrackSurface::PastAndPresentFronts{
              crack.plane.normal, crack.front_history.fronts, crack.front_history.normals});
    }
    cracks.push_back(std::move(cut));
  }
  return cracks;
}

double ellipse_parametric_angle(const model::CrackDefinition& crack, const Vec3& x) {
  const model::PlanarCrack& plane = crack.plane;
  const Vec3 from = x - plane.place;
  return std::atan2(from.dot(plane.transverse_axis()) / plane.a, from.dot(plane.along) / plane.c);
}

namespace {

PlaneBasis basis_of(const SolidCrack& crack) {
  const CrackFrame own = make_crack_frame(crack);
  return {own.origin, own.axes.col(0), own.axes.col(1), own.axes.col(2), crack.relief};
}

template <class F> void for_edges(const std::vector<std::vector<Vec2>>& outlines, F&& f) {
  for (const std::vector<Vec2>& outline : outlines) {
    for (std::size_t i = 0, j = outline.size() - 1; i < outline.size(); j = i++) {
      f(outline[j], outline[i]);
    }
  }
}

} // namespace

PlanePolygons::PlanePolygons(const PlaneBasis& plane,
                             const std::vector<std::vector<Vec3>>& outlines)
    : plane_(plane) {
  for (const std::vector<Vec3>& outline : outlines) {
    std::vector<Vec2>& flat = outlines_.emplace_back();
    for (const Vec3& x : outline) {
      flat.push_back(plane_.project(x));
    }
  }
}

PlanePolygons::PlanePolygons(const SolidCrack& crack,
                             const std::vector<std::vector<Vec3>>& outlines)
    : PlanePolygons(basis_of(crack), outlines) {}

bool PlanePolygons::contains(const Vec2& q) const {
  return std::ranges::count_if(
             outlines_,
             [&](const std::vector<Vec2>& outline) { return is_inside_polygon(q, outline); }) %
             2 ==
         1;
}

double PlanePolygons::area() const {
  double sum = 0.0;
  for (const std::vector<Vec2>& outline : outlines_) {
    double own = 0.0;
    for_edges({outline}, [&](const Vec2& a, const Vec2& b) {
      own += 0.5 * cross(a - outline.front(), b - outline.front());
    });
    const auto round = std::ranges::count_if(outlines_, [&](const std::vector<Vec2>& other) {
      return &other != &outline && is_inside_polygon(outline.front(), other);
    });
    sum += round % 2 == 0 ? std::abs(own) : -std::abs(own);
  }
  return sum;
}

double PlanePolygons::distance_to_outlines(const Vec2& q) const {
  double least = std::numeric_limits<double>::max();
  for (const std::vector<Vec2>& outline : outlines_) {
    least = std::min(least, geometry::distance_to_outline(q, outline));
  }
  return least;
}

double PlanePolygons::distance(const Vec3& x) const {
  const Vec2 q = plane_.project(x);
  return std::hypot(plane_.height_over_crack(x), contains(q) ? 0.0 : distance_to_outlines(q));
}

std::vector<Vec3>
PlanePolygons::intersect_plane_with_triangle(const geometry::CornerPlaces& triangle) const {
  std::vector<Vec2> ends;
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec3& a = triangle[i];
    const Vec3& b = triangle[(i + 1) % 3];
    const double ha = plane_.height_over_crack(a);
    const double hb = plane_.height_over_crack(b);
    if ((ha < 0.0) != (hb < 0.0)) {
      ends.push_back(plane_.project(a + ha / (ha - hb) * (b - a)));
    }
  }
  std::vector<Vec3> places;
  constexpr int steps = 8; // a triangle may be larger than the crack
  for (int i = 0; i <= steps && ends.size() == 2; ++i) {
    places.push_back(
        plane_.lift_to_crack(ends[0] + i / static_cast<double>(steps) * (ends[1] - ends[0])));
  }
  return places;
}

std::optional<double> PlanePolygons::exit_multiple_of_direction(const Vec2& q,
                                                                const Vec2& d) const {
  std::optional<double> least;
  for_edges(outlines_, [&](const Vec2& a, const Vec2& b) {
    const Vec2 side = b - a;
    const double turn = cross(d, side);
    if (std::abs(turn) < 1e-12 * side.norm() * d.norm()) {
      return;
    }
    const double along = cross(a - q, side) / turn;
    const double part = cross(a - q, d) / turn;
    const bool at_q =
        geometry::distance_to_segment(q, a, b) < 0.02 * side.norm(); // its own edge, and its chord
    if (!at_q && along > 0.0 && part >= 0.0 && part <= 1.0 && (!least || along < *least)) {
      least = along;
    }
  });
  return least;
}

} // namespace spricka::mesh
