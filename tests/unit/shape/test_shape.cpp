// SPDX-License-Identifier: GPL-3.0-or-later
#include "shape/shape.hpp"

#include "shape/topology.hpp"

#include <gtest/gtest.h>

#include <array>
#include <vector>

namespace spricka::shape {
namespace {

static_assert(Shape<Line2> && Shape<Line3>);
static_assert(ElementShape<Trim3> && ElementShape<Trimc6> && ElementShape<Quam4>);
static_assert(ElementShape<Quamc8> && ElementShape<Quamc9>);
static_assert(!ElementShape<Line3>);

template <class S> class EveryShape : public testing::Test {};
using AllShapes = testing::Types<Line2, Line3, Trim3, Trimc6, Quam4, Quamc8, Quamc9>;
TYPED_TEST_SUITE(EveryShape, AllShapes);

template <class S> class EveryElement : public testing::Test {};
using AllElements = testing::Types<Trim3, Trimc6, Quam4, Quamc8, Quamc9>;
TYPED_TEST_SUITE(EveryElement, AllElements);

// Points in and a little outside the reference domain.
template <class S> std::vector<Point<S::dim>> sample() {
  std::vector<Point<S::dim>> points;
  for (const double x : {-0.9, -0.35, 0.0, 0.2, 0.61, 1.05}) {
    for (const double y : {-0.8, 0.13, 0.47, 1.0}) {
      Point<S::dim> r;
      r[0] = x;
      if constexpr (S::dim == 2) {
        r[1] = y;
      }
      points.push_back(r);
    }
  }
  return points;
}

TYPED_TEST(EveryShape, sums_to_one) {
  for (const auto& r : sample<TypeParam>()) {
    EXPECT_NEAR(TypeParam::N(r).sum(), 1.0, 1e-14);
    EXPECT_NEAR(TypeParam::dN(r).colwise().sum().cwiseAbs().maxCoeff(), 0.0, 1e-14);
  }
}

TYPED_TEST(EveryShape, is_one_at_its_node_and_zero_at_the_others) {
  for (int i = 0; i < TypeParam::nodes; ++i) {
    const Eigen::Matrix<double, TypeParam::nodes, 1> n = TypeParam::N(node<TypeParam>(i));
    for (int j = 0; j < TypeParam::nodes; ++j) {
      EXPECT_NEAR(n[j], i == j ? 1.0 : 0.0, 1e-15) << i << ' ' << j;
    }
  }
}

TYPED_TEST(EveryShape, reproduces_the_reference_coordinates) {
  for (const auto& r : sample<TypeParam>()) {
    Point<TypeParam::dim> x = Point<TypeParam::dim>::Zero();
    Eigen::Matrix<double, TypeParam::dim, TypeParam::dim> J;
    J.setZero();
    for (int i = 0; i < TypeParam::nodes; ++i) {
      x += node<TypeParam>(i) * TypeParam::N(r)[i];
      J += node<TypeParam>(i) * TypeParam::dN(r).row(i);
    }
    EXPECT_LT((x - r).norm(), 1e-14);
    EXPECT_LT((J - decltype(J)::Identity()).norm(), 1e-14);
  }
}

TYPED_TEST(EveryShape, derivatives_agree_with_central_differences) {
  const double h = 1e-6;
  for (const auto& r : sample<TypeParam>()) {
    for (int c = 0; c < TypeParam::dim; ++c) {
      Point<TypeParam::dim> step = Point<TypeParam::dim>::Zero();
      step[c] = h;
      const Eigen::Matrix<double, TypeParam::nodes, 1> d =
          (TypeParam::N(r + step) - TypeParam::N(r - step)) / (2.0 * h);
      EXPECT_LT((d - TypeParam::dN(r).col(c)).cwiseAbs().maxCoeff(), 1e-8);
    }
  }
}

TYPED_TEST(EveryShape, nodes_lie_on_the_domain_and_the_centre_inside) {
  for (int i = 0; i < TypeParam::nodes; ++i) {
    EXPECT_LE(outside<TypeParam>(node<TypeParam>(i)), 0.0);
  }
  EXPECT_LT(outside<TypeParam>(centre<TypeParam>()), -0.3);
  EXPECT_NEAR(outside<TypeParam>(Point<TypeParam::dim>::Constant(1.25)),
              TypeParam::domain == Domain::triangle ? 1.5 : 0.25, 1e-15);
}

TYPED_TEST(EveryElement, agrees_with_the_library_table) {
  const base::ElementInfo& info = base::info(TypeParam::type);
  EXPECT_EQ(info.nodes, TypeParam::nodes);
  EXPECT_EQ(info.dim, TypeParam::dim);
  const int nodes = with_shape(TypeParam::type, []<ElementShape S>(S) { return S::nodes; });
  EXPECT_EQ(nodes, TypeParam::nodes);
}

TYPED_TEST(EveryElement, restricted_to_a_side_is_the_shape_of_the_side) {
  using Side = typename TypeParam::Side;
  for (int s = 0; s < base::info(TypeParam::type).sides; ++s) {
    const std::span<const int> local = side_nodes(TypeParam::type, s);
    ASSERT_EQ(local.size(), static_cast<std::size_t>(Side::nodes));
    for (const double t : {-0.7, 0.1, 0.85}) {
      const Eigen::Matrix<double, Side::nodes, 1> n = Side::N(Point<1>(t));
      Point<2> r = Point<2>::Zero();
      for (int i = 0; i < Side::nodes; ++i) {
        r += n[i] * node<TypeParam>(local[static_cast<std::size_t>(i)]);
      }
      Eigen::Matrix<double, TypeParam::nodes, 1> expected;
      expected.setZero();
      for (int i = 0; i < Side::nodes; ++i) {
        expected[local[static_cast<std::size_t>(i)]] = n[i];
      }
      EXPECT_LT((TypeParam::N(r) - expected).cwiseAbs().maxCoeff(), 1e-14);
    }
  }
}

} // namespace
} // namespace spricka::shape
