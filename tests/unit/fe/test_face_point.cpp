// SPDX-License-Identifier: GPL-3.0-or-later
#include "fe/face_point.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

// The nearest point of a side against all points of a fine raster on it.
namespace spricka::fe::test_face_point {
namespace {

using base::Vec3;

template <int dim>
double raster_distance(const AnyElement<dim>& side, const SpaceNodes<dim>& X, const Vec3& x) {
  constexpr int n = dim == 1 ? 4000 : 300;
  double best = 1e300;
  for (int i = 0; i <= n; ++i) {
    const double a = static_cast<double>(i) / n;
    for (int j = 0; j <= (dim == 1 ? 0 : n); ++j) {
      const double b = static_cast<double>(j) / n;
      shape::Point<dim> r;
      r[0] = 2.0 * a - 1.0;
      if constexpr (dim == 2) {
        r[1] = 2.0 * b - 1.0;
        if (side.domain == shape::ReferenceDomain::triangle) {
          r = {a * (1.0 - b), b};
        }
      }
      best = std::min(best, (x - X * side.N(r)).norm());
    }
  }
  return best;
}

// Skewed, stretched and a little curved sides, points off them and beyond their edges and corners
// by as much as a tie allows.
template <int dim> void expect_nearest_points(const AnyElement<dim>& side) {
  std::mt19937 random(7);
  const auto number = [&] { return std::uniform_real_distribution<double>(-1.0, 1.0)(random); };
  for (int trial = 0; trial < 40; ++trial) {
    const Vec3 across(2.0 * number(), 0.6, 0.4 * number());
    SpaceNodes<dim> X(3, side.nodes);
    for (int i = 0; i < side.nodes; ++i) {
      const shape::Point<dim> r = side.node_coordinates(i);
      Vec3 x(r[0], 0.0, 0.0);
      if constexpr (dim == 2) {
        x += r[1] * across;
      }
      X.col(i) = x + 0.02 * Vec3(number(), number(), number());
    }
    const double size = (X.colwise() - X.col(0)).colwise().norm().maxCoeff();
    shape::Point<dim> at;
    for (int c = 0; c < dim; ++c) {
      at[c] = 1.2 * number();
    }
    if (side.domain == shape::ReferenceDomain::triangle) {
      at = (0.5 * (at.array() + 1.0)).matrix();
    }
    const Vec3 x = X * side.N(clamp_to_side<dim>(side, at)) +
                   0.1 * size * Vec3(number(), number(), number()).normalized();
    const shape::Point<dim> r = nearest_on_side<dim>(side, X, x);
    EXPECT_LT((clamp_to_side<dim>(side, r) - r).norm(), 1e-14);
    const double raster = raster_distance<dim>(side, X, x);
    EXPECT_LT((x - X * side.N(r)).norm(), raster + 1e-9 * size) << trial;
  }
}

TEST(FacePoint, IsTheNearestOfEverySide) {
  expect_nearest_points(shape::reference_line(2));
  expect_nearest_points(shape::reference_line(3));
  for (const base::ElementType type :
       {base::ElementType::trim3, base::ElementType::trimc6, base::ElementType::quam4,
        base::ElementType::quamc8, base::ElementType::quamc9}) {
    SCOPED_TRACE(base::element_info(type).name);
    expect_nearest_points(shape::reference_element<2>(type));
  }
}

} // namespace
} // namespace spricka::fe::test_face_point
