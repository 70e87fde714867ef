// SPDX-License-Identifier: GPL-3.0-or-later
#include "fe/face_point.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

// The nearest point of a side against all points of a fine raster on it.
namespace spricka::fe {
namespace {

using base::Vec3;

template <class Side> class EverySide : public testing::Test {};
using Sides = testing::Types<shape::Line2, shape::Line3, shape::Trim3, shape::Trimc6, shape::Quam4,
                             shape::Quamc8, shape::Quamc9>;
TYPED_TEST_SUITE(EverySide, Sides);

constexpr bool is_line(shape::Domain domain) {
  return domain == shape::Domain::line;
}

template <class Side> double raster_distance(const SideNodes<Side>& X, const Vec3& x) {
  constexpr int n = is_line(Side::domain) ? 4000 : 300;
  double best = 1e300;
  for (int i = 0; i <= n; ++i) {
    const double a = static_cast<double>(i) / n;
    for (int j = 0; j <= (Side::dim == 1 ? 0 : n); ++j) {
      const double b = static_cast<double>(j) / n;
      shape::Point<Side::dim> r;
      r[0] = 2.0 * a - 1.0;
      if constexpr (Side::dim == 2) {
        r[1] = 2.0 * b - 1.0;
        if (Side::domain == shape::Domain::triangle) {
          r = {a * (1.0 - b), b};
        }
      }
      best = std::min(best, (x - X * Side::N(r)).norm());
    }
  }
  return best;
}

// Skewed, stretched and a little curved sides, points off them and beyond their edges and corners
// by as much as a tie allows.
TYPED_TEST(EverySide, has_its_nearest_point_found) {
  using Side = TypeParam;
  std::mt19937 random(7);
  const auto number = [&] { return std::uniform_real_distribution<double>(-1.0, 1.0)(random); };
  for (int trial = 0; trial < 40; ++trial) {
    const Vec3 across(2.0 * number(), 0.6, 0.4 * number());
    SideNodes<Side> X;
    for (int i = 0; i < Side::nodes; ++i) {
      const shape::Point<Side::dim> r = shape::node<Side>(i);
      Vec3 x(r[0], 0.0, 0.0);
      if constexpr (Side::dim == 2) {
        x += r[1] * across;
      }
      X.col(i) = x + 0.02 * Vec3(number(), number(), number());
    }
    const double size = (X.colwise() - X.col(0)).colwise().norm().maxCoeff();
    shape::Point<Side::dim> at;
    for (int c = 0; c < Side::dim; ++c) {
      at[c] = 1.2 * number();
    }
    if (Side::domain == shape::Domain::triangle) {
      at = (0.5 * (at.array() + 1.0)).matrix();
    }
    const Vec3 x = X * Side::N(into_side<Side>(at)) +
                   0.1 * size * Vec3(number(), number(), number()).normalized();
    const shape::Point<Side::dim> r = nearest_on_side<Side>(X, x);
    EXPECT_LT((into_side<Side>(r) - r).norm(), 1e-14);
    const double raster = raster_distance<Side>(X, x);
    EXPECT_LT((x - X * Side::N(r)).norm(), raster + 1e-9 * size) << trial;
  }
}

} // namespace
} // namespace spricka::fe
