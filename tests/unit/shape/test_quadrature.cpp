// SPDX-License-Identifier: GPL-3.0-or-later
#include "shape/quadrature.hpp"

#include "shape/solid.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace spricka::shape::test_quadrature {
namespace {

double line_moment(int degree, int p) {
  double sum = 0.0;
  for (const QuadraturePoint<1>& q : line_rule(degree)) {
    sum += q.weight * std::pow(q.r[0], p);
  }
  return sum;
}

double moment(std::span<const QuadraturePoint<2>> rule, int p, int q) {
  double sum = 0.0;
  for (const QuadraturePoint<2>& point : rule) {
    sum += point.weight * std::pow(point.r[0], p) * std::pow(point.r[1], q);
  }
  return sum;
}

double exact_line(int p) {
  return p % 2 == 0 ? 2.0 / (p + 1.0) : 0.0;
}

// Integral of x^p y^q over the triangle: p! q! / (p + q + 2)!.
double exact_triangle(int p, int q) {
  return std::exp(std::lgamma(p + 1.0) + std::lgamma(q + 1.0) - std::lgamma(p + q + 3.0));
}

class EveryDegree : public testing::TestWithParam<int> {};
INSTANTIATE_TEST_SUITE_P(quadrature, EveryDegree, testing::Range(0, max_degree + 1));

TEST_P(EveryDegree, line_is_exact) {
  for (int p = 0; p <= GetParam(); ++p) {
    EXPECT_NEAR(line_moment(GetParam(), p), exact_line(p), 3e-15) << p;
  }
}

TEST_P(EveryDegree, line_is_not_exact_beyond_its_points) {
  const int n = static_cast<int>(line_rule(GetParam()).size());
  // The error for x^2n is that of the square of the monic Legendre polynomial (n!)^4 2^(2n+1) /
  // ((2n+1) (2n)!^2).
  const double error = std::exp(4.0 * std::lgamma(n + 1.0) + (2.0 * n + 1.0) * std::log(2.0) -
                                std::log(2.0 * n + 1.0) - 2.0 * std::lgamma(2.0 * n + 1.0));
  EXPECT_NEAR(exact_line(2 * n) - line_moment(GetParam(), 2 * n), error, 1e-6 * error + 1e-15);
}

TEST_P(EveryDegree, quadrilateral_is_exact_in_each_coordinate) {
  for (int p = 0; p <= GetParam(); ++p) {
    for (int q = 0; q <= GetParam(); ++q) {
      EXPECT_NEAR(moment(quadrilateral_rule(GetParam()), p, q), exact_line(p) * exact_line(q),
                  1e-14);
    }
  }
}

TEST_P(EveryDegree, triangle_is_exact) {
  for (int p = 0; p <= GetParam(); ++p) {
    for (int q = 0; p + q <= GetParam(); ++q) {
      const double exact = exact_triangle(p, q);
      EXPECT_NEAR(moment(triangle_rule(GetParam()), p, q), exact, 1e-14 * exact + 1e-16)
          << p << ' ' << q;
    }
  }
}

TEST_P(EveryDegree, weights_are_positive_and_points_inside) {
  for (const QuadraturePoint<1>& q : line_rule(GetParam())) {
    EXPECT_GT(q.weight, 0.0);
    EXPECT_LT(distance_outside<Line2>(q.r), 0.0);
  }
  for (const QuadraturePoint<2>& q : triangle_rule(GetParam())) {
    EXPECT_GT(q.weight, 0.0);
    EXPECT_LT(distance_outside<Trim3>(q.r), 0.0);
  }
}

double moment(std::span<const QuadraturePoint<3>> rule, int p, int q, int s) {
  double sum = 0.0;
  for (const QuadraturePoint<3>& point : rule) {
    sum +=
        point.weight * std::pow(point.r[0], p) * std::pow(point.r[1], q) * std::pow(point.r[2], s);
  }
  return sum;
}

// Integral of x^p y^q z^s over the tetrahedron: p! q! s! / (p + q + s + 3)!.
double exact_tetrahedron(int p, int q, int s) {
  return std::exp(std::lgamma(p + 1.0) + std::lgamma(q + 1.0) + std::lgamma(s + 1.0) -
                  std::lgamma(p + q + s + 4.0));
}

class EverySolidDegree : public testing::TestWithParam<int> {};
INSTANTIATE_TEST_SUITE_P(quadrature, EverySolidDegree, testing::Range(0, max_solid_degree + 1));

TEST_P(EverySolidDegree, tetrahedron_is_exact) {
  const int degree = GetParam();
  for (int p = 0; p <= degree; ++p) {
    for (int q = 0; p + q <= degree; ++q) {
      for (int s = 0; p + q + s <= degree; ++s) {
        const double exact = exact_tetrahedron(p, q, s);
        EXPECT_NEAR(moment(tetrahedron_rule(degree), p, q, s), exact, 1e-14 * exact + 1e-16)
            << p << ' ' << q << ' ' << s;
      }
    }
  }
}

TEST_P(EverySolidDegree, prism_is_exact) {
  const int degree = GetParam();
  for (int p = 0; p <= degree; ++p) {
    for (int q = 0; p + q <= degree; ++q) {
      for (int s = 0; s <= degree; ++s) {
        EXPECT_NEAR(moment(prism_rule(degree), p, q, s), exact_triangle(p, q) * exact_line(s),
                    1e-14);
      }
    }
  }
}

TEST_P(EverySolidDegree, hexahedron_is_exact_in_each_coordinate) {
  const int degree = GetParam();
  for (int p = 0; p <= degree; ++p) {
    for (int q = 0; q <= degree; ++q) {
      for (int s = 0; s <= degree; ++s) {
        EXPECT_NEAR(moment(hexahedron_rule(degree), p, q, s),
                    exact_line(p) * exact_line(q) * exact_line(s), 3e-14);
      }
    }
  }
}

TEST_P(EverySolidDegree, weights_sum_to_the_volume_and_are_positive_and_points_inside) {
  double sum = 0.0;
  for (const QuadraturePoint<3>& q : tetrahedron_rule(GetParam())) {
    EXPECT_GT(q.weight, 0.0);
    EXPECT_LT(distance_outside<Tet4>(q.r), 0.0);
    sum += q.weight;
  }
  EXPECT_NEAR(sum, 1.0 / 6.0, 1e-15);
  for (const QuadraturePoint<3>& q : prism_rule(GetParam())) {
    EXPECT_GT(q.weight, 0.0);
    EXPECT_LT(distance_outside<Penta6>(q.r), 0.0);
  }
  for (const QuadraturePoint<3>& q : hexahedron_rule(GetParam())) {
    EXPECT_GT(q.weight, 0.0);
    EXPECT_LT(distance_outside<Hexe8>(q.r), 0.0);
  }
}

// The rules change their points behind these degrees; 1 is the one-point rule.
TEST(quadrature, tetrahedron_is_not_exact_at_the_next_degree) {
  for (const int degree : {1, 2, 5, 6}) {
    double worst = 0.0;
    for (int p = 0; p <= degree + 1; ++p) {
      for (int q = 0; p + q <= degree + 1; ++q) {
        const int s = degree + 1 - p - q;
        const double found = moment(tetrahedron_rule(degree), p, q, s);
        worst = std::max(worst, std::abs(found / exact_tetrahedron(p, q, s) - 1.0));
      }
    }
    EXPECT_GT(worst, 1e-4) << degree;
  }
}

class SymmetricDegree : public testing::TestWithParam<int> {};
INSTANTIATE_TEST_SUITE_P(quadrature, SymmetricDegree, testing::Values(0, 2, 4, 5, 6, 8));

// 0 stands for the one-point rule, which is exact for degree 1.
TEST_P(SymmetricDegree, triangle_is_not_exact_at_the_next_degree) {
  const int degree = std::max(GetParam(), 1);
  double worst = 0.0;
  for (int p = 0; p <= degree + 1; ++p) {
    const int q = degree + 1 - p;
    worst =
        std::max(worst, std::abs(moment(triangle_rule(degree), p, q) / exact_triangle(p, q) - 1.0));
  }
  EXPECT_GT(worst, 1e-4);
}

TEST(quadrature, takes_the_rule_of_the_shape) {
  EXPECT_EQ(quadrature<Trim3>().size(), 1U);
  EXPECT_EQ(quadrature<Trimc6>().size(), 12U);
  EXPECT_EQ(quadrature<Quam4>().size(), 4U);
  EXPECT_EQ(quadrature<Quamc8>().size(), 9U);
  EXPECT_EQ(quadrature<Quamc9>().size(), 9U);
  EXPECT_EQ(quadrature<Line3>(5).size(), 3U);
  EXPECT_EQ(quadrature<Tet4>().size(), 1U);
  EXPECT_EQ(quadrature<Tet10>().size(), 14U);
  EXPECT_EQ(quadrature<Penta6>().size(), 6U);
  EXPECT_EQ(quadrature<Pentac15>().size(), 21U);
  EXPECT_EQ(quadrature<Hexe8>().size(), 8U);
  EXPECT_EQ(quadrature<Hexec20>().size(), 27U);
  EXPECT_EQ(quadrature<Hexec27>().size(), 27U);
}

} // namespace
} // namespace spricka::shape::test_quadrature
