// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "geometry/box.hpp"

#include <array>
#include <limits>
#include <vector>

namespace spricka::geometry {

/// The point of a triangle that is nearest to another point, and what it lies on: a corner, else an
/// edge (edge i runs from corner i to the next), else within.
struct NearestTrianglePoint {
  base::Vec3 x = base::Vec3::Zero();
  int corner = -1; ///< -1: none
  int edge = -1;   ///< -1: none
};

/// By the regions of the triangle's plane (Ericson 2005, section 5.1.5).
NearestTrianglePoint nearest_point(const base::Vec3& x, const std::array<base::Vec3, 3>& triangle);

using CornerPlaces = std::array<base::Vec3, 3>;

/// Triangles in a tree of boxes.
class TriangleTree {
public:
  explicit TriangleTree(std::vector<CornerPlaces> triangles);

  struct NearestTriangle {
    static constexpr std::size_t none = std::numeric_limits<std::size_t>::max();
    double distance = std::numeric_limits<double>::max();
    base::Vec3 at = base::Vec3::Constant(std::numeric_limits<double>::quiet_NaN());
    std::size_t given = none; ///< of the triangles the tree was made of
  };
  /// The triangle nearest to a point and the place on it. An empty tree has none: the largest
  /// distance there is, no place (NaN), the number `none`.
  [[nodiscard]] NearestTriangle nearest(const base::Vec3& p) const;
  [[nodiscard]] const std::vector<CornerPlaces>& triangles() const { return triangles_; }

private:
  struct TriangleTreeNode {
    Box<3> box;
    std::size_t begin = 0, end = 0;  ///< of triangles
    std::size_t left = 0, right = 0; ///< boxes; 0: none
  };
  struct NumberedTriangle {
    CornerPlaces x;
    std::size_t number = 0;
  };
  std::size_t make(std::vector<NumberedTriangle>& all, std::size_t begin, std::size_t end);

  std::vector<CornerPlaces> triangles_;
  std::vector<std::size_t> given_; ///< [triangle]
  std::vector<TriangleTreeNode> boxes_;
};

} // namespace spricka::geometry
