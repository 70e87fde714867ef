// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/rigid_target.hpp"

#include "model/contacts.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace spricka::contact {

namespace {

constexpr double snap = 1e-9; // cuts this near to a node, or points to an end, are there

RigidProjection foot_on_line(const model::RigidTarget& line, const Vec2& x) {
  const Vec2 first = line.first.head<2>();
  const Vec2 chord = line.second.head<2>() - first;
  const double length = chord.norm();
  const Vec2 t = chord / length;
  const double along = (x - first).dot(t);
  RigidProjection foot;
  foot.normal = {t.y(), -t.x()};                 // the body is on the left
  foot.gap = 0.0 - (x - first).dot(foot.normal); // never -0
  foot.point = x + foot.gap * foot.normal;
  foot.beyond = along < -snap * length || along > (1.0 + snap) * length;
  return foot;
}

// xi between -1 and 1 at which the edge passes the perpendicular through `end`: t . (x - end) = 0.
void add_cuts(const Edge& edge, const Vec2& end, const Vec2& t, std::vector<double>& cuts) {
  const double a = (edge.x[0] - end).dot(t);
  const double b = (edge.x[1] - end).dot(t);
  // h = c0 + c1 xi + c2 xi^2 through the values at the nodes
  double c0 = 0.5 * (a + b);
  const double c1 = 0.5 * (b - a);
  double c2 = 0.0;
  if (edge.count == 3) {
    const double m = (edge.x[2] - end).dot(t);
    c2 = c0 - m;
    c0 = m;
  }
  // The stable form of the quadratic formula: no difference of nearly equal numbers.
  const double root = c1 * c1 - 4.0 * c2 * c0;
  if (root < 0.0) {
    return;
  }
  const double q = -0.5 * (c1 + std::copysign(std::sqrt(root), c1));
  for (const auto& [top, bottom] : {std::pair{q, c2}, std::pair{c0, q}}) {
    if (std::abs(top) < std::abs(bottom)) {
      cuts.push_back(top / bottom);
    }
  }
}

// Cuts in order; those within round-off of a node are at the node.
void settle(std::vector<double>& cuts) {
  for (double& cut : cuts) {
    for (const double node : {-1.0, 0.0, 1.0}) {
      cut = std::abs(cut - node) < snap ? node : cut;
    }
  }
  std::sort(cuts.begin(), cuts.end());
}

// Whether a point of an edge looks at the target, near enough and between its ends.
bool faces(const ContactSurface& contact, const Edge& edge, const model::RigidTarget& rigid,
           double xi) {
  const std::optional<RigidProjection> foot = normal_projection(rigid, point_on_edge(edge, xi));
  return foot && !foot->beyond && outer_normal(edge, xi).dot(foot->normal) > 0.0 &&
         std::abs(foot->gap) <= farthest_opposite * contact.extent;
}

} // namespace

std::optional<RigidProjection> normal_projection(const model::RigidTarget& rigid, const Vec2& x) {
  if (rigid.shape == model::RigidTargetShape::line) {
    return foot_on_line(rigid, x);
  }
  const Vec2 centre = rigid.first.head<2>();
  const double distance = (x - centre).norm();
  const double radius = std::abs(rigid.radius);
  if (distance < 1e-9 * radius) {
    return std::nullopt;
  }
  const Vec2 outward = (x - centre) / distance;
  RigidProjection foot;
  foot.point = centre + radius * outward;
  // (contact.13): with a radius above 0 the body is outside, below 0 inside.
  foot.gap = rigid.radius > 0.0 ? distance - radius : radius - distance;
  foot.normal = rigid.radius > 0.0 ? Vec2(-outward) : outward;
  return foot;
}

std::vector<MortarSegment> find_mortar_segments(const ContactSurface& contact,
                                                const model::RigidTarget& rigid) {
  std::vector<MortarSegment> all;
  std::size_t number = 0;
  for (const Edge& edge : contact.plane.edges) {
    std::vector<double> cuts{-1.0, 1.0};
    if (edge.count == 3) {
      cuts.push_back(0.0);
    }
    if (rigid.shape == model::RigidTargetShape::line) {
      const Vec2 first = rigid.first.head<2>();
      const Vec2 second = rigid.second.head<2>();
      const Vec2 t = (second - first).normalized();
      add_cuts(edge, first, t, cuts);
      add_cuts(edge, second, t, cuts);
    }
    settle(cuts);
    for (std::size_t i = 0; i + 1 < cuts.size(); ++i) {
      if (cuts[i + 1] - cuts[i] > shortest_interval &&
          faces(contact, edge, rigid, 0.5 * (cuts[i] + cuts[i + 1]))) {
        all.push_back({number, 0, cuts[i], cuts[i + 1]});
      }
    }
    ++number;
  }
  return all;
}

} // namespace spricka::contact
