// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/triangle.hpp"

#include <algorithm>

namespace spricka::geometry {

using base::Vec3;

NearestTrianglePoint nearest_point(const Vec3& x, const std::array<Vec3, 3>& triangle) {
  const auto& [a, b, c] = triangle;
  const Vec3 ab = b - a;
  const Vec3 ac = c - a;
  const double d1 = ab.dot(x - a);
  const double d2 = ac.dot(x - a);
  if (d1 <= 0.0 && d2 <= 0.0) {
    return {a, 0, -1};
  }
  const double d3 = ab.dot(x - b);
  const double d4 = ac.dot(x - b);
  if (d3 >= 0.0 && d4 <= d3) {
    return {b, 1, -1};
  }
  const double vc = d1 * d4 - d3 * d2;
  if (vc <= 0.0 && d1 >= 0.0 && d3 <= 0.0) {
    return {a + d1 / (d1 - d3) * ab, -1, 0};
  }
  const double d5 = ab.dot(x - c);
  const double d6 = ac.dot(x - c);
  if (d6 >= 0.0 && d5 <= d6) {
    return {c, 2, -1};
  }
  const double vb = d5 * d2 - d1 * d6;
  if (vb <= 0.0 && d2 >= 0.0 && d6 <= 0.0) {
    return {a + d2 / (d2 - d6) * ac, -1, 2};
  }
  const double va = d3 * d6 - d5 * d4;
  if (va <= 0.0 && d4 >= d3 && d5 >= d6) {
    return {b + (d4 - d3) / ((d4 - d3) + (d5 - d6)) * (c - b), -1, 1};
  }
  const double sum = va + vb + vc;
  return {a + vb / sum * ab + vc / sum * ac, -1, -1};
}

TriangleTree::TriangleTree(std::vector<CornerPlaces> triangles) : triangles_(std::move(triangles)) {
  std::vector<NumberedTriangle> all;
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

std::size_t TriangleTree::make(std::vector<NumberedTriangle>& all, std::size_t begin,
                               std::size_t end) {
  constexpr std::size_t few = 8;
  Box<3> box;
  for (std::size_t i = begin; i < end; ++i) {
    box.extend(Box<3>::around(all[i].x));
  }
  const std::size_t own = boxes_.size();
  boxes_.push_back({box, begin, end, 0, 0});
  if (end - begin > few) {
    Eigen::Index axis = 0;
    (box.high - box.low).maxCoeff(&axis);
    const std::size_t middle = begin + (end - begin) / 2;
    const auto at = [&](std::size_t i) { return all.begin() + static_cast<std::ptrdiff_t>(i); };
    const auto sum = [&](const NumberedTriangle& t) {
      return t.x[0][axis] + t.x[1][axis] + t.x[2][axis];
    };
    std::nth_element(
        at(begin), at(middle), at(end),
        [&](const NumberedTriangle& s, const NumberedTriangle& t) { return sum(s) < sum(t); });
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
    const TriangleTreeNode& box = boxes_[open.back()];
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
      const Vec3 at = nearest_point(p, triangles_[i]).x;
      if (const double d = (at - p).norm(); d < best.distance) {
        best = {d, at, given_[i]};
      }
    }
  }
  return best;
}

} // namespace spricka::geometry
