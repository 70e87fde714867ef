// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/space/clip.hpp"

#include <random>

#include <gtest/gtest.h>

namespace spricka::contact::test_clip {
namespace {

using base::Vec2;

double area_of(const std::vector<Vec2>& polygon) {
  double twice = 0.0;
  for (std::size_t i = 0; i + 2 < polygon.size(); ++i) {
    twice += twice_area({polygon[0], polygon[i + 1], polygon[i + 2]});
  }
  return 0.5 * twice;
}

PlaneTriangle random_triangle(std::mt19937& random) {
  std::uniform_real_distribution<double> at(0.0, 1.0);
  PlaneTriangle t{Vec2(at(random), at(random)), Vec2(at(random), at(random)),
                  Vec2(at(random), at(random))};
  if (twice_area(t) < 0.0) {
    std::swap(t[1], t[2]);
  }
  return t;
}

TEST(Clip, PiecesOfATriangleMakeItUp) {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> share(0.1, 0.9);
  for (int i = 0; i < 200; ++i) {
    const PlaneTriangle whole = random_triangle(random);
    const PlaneTriangle other = random_triangle(random);
    // A fan of three about an inner point: what `other` has in common with them is that with all.
    const double a = share(random);
    const double b = share(random) * (1.0 - a);
    const Vec2 inner = a * whole[0] + b * whole[1] + (1.0 - a - b) * whole[2];
    double sum = 0.0;
    for (std::size_t k = 0; k < 3; ++k) {
      sum += area_of(intersect_triangles({whole[k], whole[(k + 1) % 3], inner}, other));
    }
    EXPECT_NEAR(sum, area_of(intersect_triangles(whole, other)), 1e-14);
    EXPECT_NEAR(area_of(intersect_triangles(other, whole)),
                area_of(intersect_triangles(whole, other)), 1e-14);
    EXPECT_LE(intersect_triangles(whole, other).size(), 6U);
  }
}

TEST(Clip, TheSameTwiceIsItself) {
  const PlaneTriangle t{Vec2(0.0, 0.0), Vec2(3.0, 0.0), Vec2(1.0, 2.0)};
  EXPECT_DOUBLE_EQ(area_of(intersect_triangles(t, t)), 3.0);
  EXPECT_TRUE(intersect_triangles(t, {Vec2(4.0, 0.0), Vec2(5.0, 0.0), Vec2(4.0, 1.0)}).empty());
}

TEST(Clip, BarycentricCoordinatesGiveThePointBack) {
  std::mt19937 random(5);
  const PlaneTriangle t = random_triangle(random);
  const Vec2 x(0.3, -2.0); // outside too
  const Eigen::Vector3d share = barycentric_coordinates(t, x);
  EXPECT_NEAR(share.sum(), 1.0, 1e-14);
  EXPECT_LT((share[0] * t[0] + share[1] * t[1] + share[2] * t[2] - x).norm(), 1e-12);
}

} // namespace
} // namespace spricka::contact::test_clip
