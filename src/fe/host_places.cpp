// SPDX-License-Identifier: GPL-3.0-or-later
#include "fe/host_places.hpp"

#include "geometry/polyline.hpp"
#include "shape/shape.hpp"
#include "shape/topology.hpp"

#include <algorithm>

namespace spricka::fe {

namespace {

using base::Vec2;

constexpr int pieces = 16; ///< of a curved side

double cross(const Vec2& a, const Vec2& b) {
  return a.x() * b.y() - a.y() * b.x();
}

// Outline of an element of the plane, anticlockwise.
std::vector<Vec2> outline_of(const model::Mesh& mesh, base::ElementId e) {
  const base::ElementType type = mesh.type[e.index()];
  const auto nodes = mesh.element_nodes(e);
  const auto at = [&](int i) -> Vec2 {
    return mesh.x[nodes[static_cast<std::size_t>(i)].index()].head<2>();
  };
  std::vector<Vec2> points;
  for (int s = 0; s < base::element_info(type).sides; ++s) {
    const auto side = shape::side_nodes(type, s);
    const Vec2 a = at(side[0]);
    const Vec2 b = at(side[1]);
    points.push_back(a);
    if (side.size() < 3) {
      continue;
    }
    const Vec2 m = at(side[2]);
    // A straight side needs no pieces.
    if (std::abs(cross(b - a, m - a)) <= 1e-12 * (b - a).squaredNorm()) {
      continue;
    }
    for (int i = 1; i < pieces; ++i) {
      const Eigen::Vector3d N = shape::Line3::N(shape::Point<1>(2.0 * i / pieces - 1.0));
      points.emplace_back(N[0] * a + N[1] * b + N[2] * m);
    }
  }
  return points;
}

bool is_inside(const std::vector<Vec2>& outline, const Vec2& p) {
  // Even-odd rule.
  bool inside = false;
  Vec2 a = outline.back();
  for (const Vec2& b : outline) {
    if ((a.y() > p.y()) != (b.y() > p.y()) &&
        p.x() < a.x() + (p.y() - a.y()) / (b.y() - a.y()) * (b.x() - a.x())) {
      inside = !inside;
    }
    a = b;
  }
  return inside;
}

} // namespace

HostElementFinder::HostElementFinder(const PatchedMesh& patched) {
  if (patched.host == nullptr) {
    return;
  }
  std::vector<bool> kept(patched.host_mesh.element_count(), false);
  for (const base::ElementId e : *patched.host) {
    if (e.valid()) {
      kept[e.index()] = true;
    }
  }
  std::vector<geometry::Box<2>> boxes;
  for (std::size_t e = 0; e < kept.size(); ++e) {
    if (kept[e]) {
      continue;
    }
    taken_.emplace_back(e);
    outlines_.push_back(outline_of(patched.host_mesh, base::ElementId(e)));
    boxes.push_back(geometry::Box<2>::around(outlines_.back()));
  }
  boxes_ = geometry::BoxTree<2>(boxes);
}

base::ElementId HostElementFinder::at(const Vec2& x) const {
  for (const std::size_t i : boxes_.boxes_containing(x)) {
    if (is_inside(outlines_[i], x)) {
      return taken_[i];
    }
  }
  // outside all, by round-off or beside a curved side
  const std::optional<std::size_t> nearest = boxes_.nearest(
      x, [&](std::size_t i) { return geometry::distance_to_outline(x, outlines_[i]); });
  return nearest ? taken_[*nearest] : base::ElementId();
}

} // namespace spricka::fe
