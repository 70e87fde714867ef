// SPDX-License-Identifier: GPL-3.0-or-later
#include "crack/front_rule.hpp"

#include <algorithm>
#include <array>
#include <limits>

namespace spricka::crack {

using base::Vec3;

namespace {

// Elements need less the farther they are by their half width: K moves by 1e-5 of its largest
// value, as it does by front_degree at the front itself, and by 5e-5 where there is no tube.
struct FarRule {
  double from = 0.0;
  int degree = front_degree;
};
constexpr std::array<FarRule, 2> far_rules{{{0.3, 7}, {0.8, 6}}};

// The auxiliary fields' derivatives grow faster towards the line of the front's centres of
// curvature: it counts as nearer.
constexpr double of_centres = 0.25;

// How far an element is from where the auxiliary fields have no bound, by its half width: from the
// front and, inside a bend, from the line of its centres of curvature. Both across the front.
double distance_by_width(const model::Mesh& mesh, base::ElementId e,
                         const mesh::FrontCurve& curve) {
  const std::span<const base::NodeId> nodes = mesh.element_nodes(e);
  Vec3 centre = Vec3::Zero();
  for (const base::NodeId n : nodes) {
    centre += mesh.x[n.index()] / static_cast<double>(nodes.size());
  }
  const double s = curve.nearest_length(centre);
  const mesh::FrontFrame foot = curve.at(curve.closed() ? s : std::clamp(s, 0.0, curve.length()));
  const double bend = foot.dt.norm();
  // From the front beside a place, which bends away from its tangent, and from the centre.
  const auto off_front = [&](const Vec3& d) -> Vec3 {
    const double along = d.dot(foot.t);
    return d - along * foot.t - 0.5 * along * along * foot.dt;
  };
  double nearest = std::numeric_limits<double>::infinity();
  double width = 0.0;
  for (const base::NodeId n : nodes) {
    const Vec3 d = off_front(mesh.x[n.index()] - foot.x);
    nearest = std::min(nearest, d.norm());
    if (bend > 0.0) {
      nearest = std::min(nearest, of_centres * (1.0 - d.dot(foot.dt)) / bend);
    }
    width = std::max(width, off_front(mesh.x[n.index()] - centre).norm());
  }
  return nearest / width;
}

} // namespace

int front_quadrature_degree(const model::Mesh& mesh, base::ElementId e,
                            const mesh::FrontCurve& curve) {
  const double distance = distance_by_width(mesh, e, curve);
  int degree = front_degree;
  for (const FarRule& rule : far_rules) {
    degree = distance < rule.from ? degree : rule.degree;
  }
  return degree;
}

} // namespace spricka::crack
