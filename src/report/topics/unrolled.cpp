// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/topics/unrolled.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace spricka::report {

namespace {

using std::numbers::pi;

constexpr int parts_of_turn = 180;  // of the integral round the axis
constexpr double past_sides = 1e-9; // of a triangle

double cross(DrawingPoint a, DrawingPoint b, DrawingPoint c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

geometry::BoxTree<2> tree_of(const std::vector<UnrolledSurface::Triangle>& triangles) {
  std::vector<geometry::Box<2>> boxes;
  boxes.reserve(triangles.size());
  for (const UnrolledSurface::Triangle& t : triangles) {
    geometry::Box<2> box;
    for (const UnrolledSurface::UnrolledCorner& c : t) {
      box.extend({{c.at.x, c.at.y}, {c.at.x, c.at.y}});
    }
    boxes.push_back(box.grown(2.0 * past_sides * box.diagonal()));
  }
  return geometry::BoxTree<2>(boxes);
}

} // namespace

UnrolledSurface::UnrolledSurface(const results::ContactResult& contact, bool consistent)
    : radius_(contact.radius), low_(std::numeric_limits<double>::infinity()), high_(-low_) {
  const auto corner = [&](std::size_t k) {
    const results::ContactPoint& p = contact.points[static_cast<std::size_t>(contact.corners[k])];
    return UnrolledCorner{{p.theta, p.arc}, consistent ? p.p_consistent : p.p_lumped};
  };
  for (std::size_t k = 0; k + 2 < contact.corners.size(); k += 3) {
    Triangle t{corner(k), corner(k + 1), corner(k + 2)};
    double most = t[0].at.x;
    double least = most;
    for (UnrolledCorner& c : t) {
      c.at.x = t[0].at.x + std::remainder(c.at.x - t[0].at.x, 2.0 * pi);
      most = std::max(most, c.at.x);
      least = std::min(least, c.at.x);
      low_ = std::min(low_, c.at.y);
      high_ = std::max(high_, c.at.y);
      largest_ = std::max(largest_, c.p);
    }
    triangles_.push_back(t);
    const double shift = most > pi ? -2.0 * pi : least < -pi ? 2.0 * pi : 0.0;
    if (shift != 0.0) {
      for (UnrolledCorner& c : t) {
        c.at.x += shift;
      }
      triangles_.push_back(t);
    }
  }
  tree_ = std::make_shared<const geometry::BoxTree<2>>(tree_of(triangles_));
}

std::optional<double> UnrolledSurface::pressure_at(DrawingPoint at) const {
  for (const std::size_t i : tree_->boxes_containing({at.x, at.y})) {
    const Triangle& t = triangles_[i];
    const double whole = cross(t[0].at, t[1].at, t[2].at);
    const double b = cross(t[2].at, t[0].at, at) / whole;
    const double c = cross(t[0].at, t[1].at, at) / whole;
    if (b >= -past_sides && c >= -past_sides && b + c <= 1.0 + past_sides) {
      return (1.0 - b - c) * t[0].p + b * t[1].p + c * t[2].p;
    }
  }
  return std::nullopt;
}

DrawingPoint UnrolledSurface::line_force_at_axial_position(double along) const {
  DrawingPoint sum;
  for (int i = 0; i < parts_of_turn; ++i) {
    const double angle = -pi + 2.0 * pi * (i + 0.5) / parts_of_turn;
    const double p = pressure_at({angle, along}).value_or(0.0);
    sum.x += p * std::cos(angle);
    sum.y += p * std::sin(angle);
  }
  const double part = radius_ * 2.0 * pi / parts_of_turn;
  return {part * sum.x, part * sum.y};
}

} // namespace spricka::report
