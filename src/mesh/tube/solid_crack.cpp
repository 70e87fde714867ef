// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/tube/solid_crack.hpp"

#include "geometry/polyline.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include <Eigen/Geometry>

namespace spricka::mesh {

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

std::shared_ptr<const NonPlanarCrackSurface> crack_surface_in_frame(const CrackFrame& frame,
                                                                    const SolidCrack& crack) {
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

void update_front_points(const model::Mesh& mesh, CrackFront& front) {
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

} // namespace spricka::mesh
