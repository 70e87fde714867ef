// SPDX-License-Identifier: GPL-3.0-or-later
#include "fe/host_places.hpp"

#include "fe/element_outline.hpp"
#include "geometry/polyline.hpp"

#include <algorithm>

namespace spricka::fe {

namespace {

using base::Vec2;

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
    outlines_.push_back(element_outline(patched.host_mesh, base::ElementId(e)));
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
