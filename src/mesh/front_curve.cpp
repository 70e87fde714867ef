// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/front_curve.hpp"

#include <cassert>
#include <utility>

#include <Eigen/Geometry>

namespace spricka::mesh {

using base::Vec3;

FrontCurve::FrontCurve(std::vector<Vec3> points, std::vector<Vec3> normals, bool closed)
    : x_(std::move(points)), normal_(std::move(normals)), curve_(x_, closed) {
  assert(x_.size() == normal_.size());
}

FrontFrame FrontCurve::at(double s) const {
  FrontFrame frame;
  frame.s = s;
  const geometry::SplineCurvePoint point = curve_.point(s);
  frame.x = point.x;
  const double speed = point.first.norm();
  frame.t = point.first / speed;
  frame.dt = (point.second - frame.t.dot(point.second) * frame.t) / (speed * speed);
  // b: between those of the knots, at right angles to t.
  const std::size_t before = point.position.interval;
  const Vec3 turn = normal_[(before + 1) % normal_.size()] - normal_[before];
  const double width = curve_.spline().interval_width(before);
  const Vec3 b0 = normal_[before] + point.position.offset / width * turn;
  const Vec3 db0 = turn / (width * speed);
  const Vec3 flat = b0 - frame.t.dot(b0) * frame.t;
  const Vec3 dflat =
      db0 - (frame.dt.dot(b0) + frame.t.dot(db0)) * frame.t - frame.t.dot(b0) * frame.dt;
  frame.b = flat.normalized();
  frame.db = (dflat - frame.b.dot(dflat) * frame.b) / flat.norm();
  frame.m = frame.b.cross(frame.t);
  frame.dm = frame.db.cross(frame.t) + frame.b.cross(frame.dt);
  if (point.beyond != 0.0) {
    frame.dt.setZero();
    frame.dm.setZero();
    frame.db.setZero();
  }
  return frame;
}

} // namespace spricka::mesh
