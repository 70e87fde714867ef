// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/tube/cracks_in_solids.hpp"

#include "mesh/front_curve.hpp"
#include "mesh/surface/crack_relief.hpp"
#include "model/model.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <Eigen/Geometry>

namespace spricka::mesh {

namespace {

using base::Vec3;

constexpr int ellipse_points = 360; // a spline through them is exact to 1e-9 of the axes

// t = m x b with m outwards: clockwise, seen from where the normal points to.
std::vector<Vec3> ellipse_front(const model::PlanarCrack& plane) {
  std::vector<Vec3> front;
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
          std::make_shared<const NonPlanarCrackSurface>(NonPlanarCrackSurface::SuccessiveFronts{
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

} // namespace spricka::mesh
