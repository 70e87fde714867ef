// SPDX-License-Identifier: GPL-3.0-or-later
#include "crack/curvature_limit.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace spricka::crack {

using base::ElementId;
using base::NodeId;
using base::Vec3;

namespace {

// Part of the way to the centre of curvature that elements of a domain may take: there places along
// the front run together, and what the auxiliary fields' derivatives grow by (the third power of
// what is left) no rule of such wide elements follows.
constexpr double largest_to_centre = 0.6;
// The front may turn within an element of a domain by twice as much as from a point to the next,
// and by this more [rad].
constexpr double more_turn = 0.35;

} // namespace

bool DomainCurvatureLimit::is_exceeded(std::size_t point, const VirtualExtensionField& field) {
  const double least =
      std::cos(std::min(2.0 * turn_beside(point) + more_turn, 0.5 * std::numbers::pi));
  return std::ranges::any_of(field.elements, [&](ElementId e) {
    const std::span<const NodeId> nodes = mesh_.element_nodes(e);
    const Vec3 first = place_at(nodes.front()).m;
    return std::ranges::any_of(nodes, [&](NodeId n) {
      const NodeFrontPosition& place = place_at(n);
      return place.to_centre > largest_to_centre || place.m.dot(first) < least;
    });
  });
}

// How much the front turns from a point to its neighbours [rad].
double DomainCurvatureLimit::turn_beside(std::size_t point) const {
  const std::size_t count = front_.points.size();
  double turn = 0.0;
  for (const std::size_t next : {(point + 1) % count, (point + count - 1) % count}) {
    const bool beside = next + 1 == point || point + 1 == next;
    if (closed_ || beside) {
      const double cosine = front_.points[point].growth.dot(front_.points[next].growth);
      turn = std::max(turn, std::acos(std::clamp(cosine, -1.0, 1.0)));
    }
  }
  return turn;
}

const DomainCurvatureLimit::NodeFrontPosition& DomainCurvatureLimit::place_at(NodeId n) {
  const auto [at, fresh] = near_front_.try_emplace(n);
  if (fresh) {
    // Beyond an open end axes turn as they do there.
    const mesh::FrontCurve& curve = *front_.curve;
    const Vec3& x = mesh_.x[n.index()];
    const double s = curve.nearest_length(x);
    const mesh::FrontFrame frame =
        curve.at(curve.closed() ? s : std::clamp(s, 0.0, curve.length()));
    at->second = {frame.m, (x - frame.x).dot(frame.dt)};
  }
  return at->second;
}

} // namespace spricka::crack
