// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/triangle.hpp"

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

} // namespace spricka::geometry
