// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/surface/triangle_tree.hpp"

#include "geometry/triangle.hpp"

#include <algorithm>

namespace spricka::mesh {

using base::Vec3;

TriangleTree::TriangleTree(std::vector<CornerPlaces> triangles) : triangles_(std::move(triangles)) {
  std::vector<InputTriangle> all;
  all.reserve(triangles_.size());
  for (std::size_t i = 0; i < triangles_.size(); ++i) {
    all.push_back({triangles_[i], i});
  }
  if (!all.empty()) {
    make(all, 0, all.size());
  }
  for (std::size_t i = 0; i < all.size(); ++i) {
    triangles_[i] = all[i].x;
    given_.push_back(all[i].number);
  }
}

std::size_t TriangleTree::make(std::vector<InputTriangle>& all, std::size_t begin,
                               std::size_t end) {
  constexpr std::size_t few = 8;
  geometry::Box<3> box;
  for (std::size_t i = begin; i < end; ++i) {
    box.extend(geometry::Box<3>::around(all[i].x));
  }
  const std::size_t own = boxes_.size();
  boxes_.push_back({box, begin, end, 0, 0});
  if (end - begin > few) {
    Eigen::Index axis = 0;
    (box.high - box.low).maxCoeff(&axis);
    const std::size_t middle = begin + (end - begin) / 2;
    const auto at = [&](std::size_t i) { return all.begin() + static_cast<std::ptrdiff_t>(i); };
    const auto sum = [&](const InputTriangle& t) {
      return t.x[0][axis] + t.x[1][axis] + t.x[2][axis];
    };
    std::nth_element(
        at(begin), at(middle), at(end),
        [&](const InputTriangle& s, const InputTriangle& t) { return sum(s) < sum(t); });
    const std::size_t left = make(all, begin, middle);
    const std::size_t right = make(all, middle, end);
    boxes_[own].left = left;
    boxes_[own].right = right;
  }
  return own;
}

TriangleTree::NearestTriangle TriangleTree::nearest(const Vec3& p) const {
  NearestTriangle best;
  std::vector<std::size_t> open;
  if (!boxes_.empty()) {
    open.push_back(0);
  }
  while (!open.empty()) {
    const TriangleBox& box = boxes_[open.back()];
    open.pop_back();
    if (box.box.distance(p) >= best.distance) {
      continue;
    }
    if (box.left != 0) {
      const bool left_first = boxes_[box.left].box.distance(p) < boxes_[box.right].box.distance(p);
      open.push_back(left_first ? box.right : box.left);
      open.push_back(left_first ? box.left : box.right);
      continue;
    }
    for (std::size_t i = box.begin; i < box.end; ++i) {
      const Vec3 at = geometry::nearest_point(p, triangles_[i]).x;
      if (const double d = (at - p).norm(); d < best.distance) {
        best = {d, at, given_[i]};
      }
    }
  }
  return best;
}

} // namespace spricka::mesh
