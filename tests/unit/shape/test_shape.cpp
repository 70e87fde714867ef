// SPDX-License-Identifier: GPL-3.0-or-later
#include "shape/solid.hpp"

#include "shape/quadrature.hpp"
#include "shape/reference_element.hpp"
#include "shape/topology.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include <array>
#include <cmath>
#include <vector>

namespace spricka::shape::test_shape {
namespace {

static_assert(Shape<Line2> && Shape<Line3>);
static_assert(PlaneShape<Trim3> && PlaneShape<Trimc6> && PlaneShape<Quam4>);
static_assert(PlaneShape<Quamc8> && PlaneShape<Quamc9>);
static_assert(ElementShape<Tet4> && ElementShape<Tet10> && ElementShape<Hexec27>);
static_assert(!ElementShape<Line3> && !PlaneShape<Hexe8>);

template <class S> class EveryShape : public testing::Test {};
using AllShapes = testing::Types<Line2, Line3, Trim3, Trimc6, Quam4, Quamc8, Quamc9, Tet4, Tet10,
                                 Penta6, Pentac15, Hexe8, Hexec20, Hexec27>;
TYPED_TEST_SUITE(EveryShape, AllShapes);

template <class S> class EveryElement : public testing::Test {};
using AllElements = testing::Types<Trim3, Trimc6, Quam4, Quamc8, Quamc9, Tet4, Tet10, Penta6,
                                   Pentac15, Hexe8, Hexec20, Hexec27>;
TYPED_TEST_SUITE(EveryElement, AllElements);

template <class S> class EveryPlane : public testing::Test {};
using AllPlanes = testing::Types<Trim3, Trimc6, Quam4, Quamc8, Quamc9>;
TYPED_TEST_SUITE(EveryPlane, AllPlanes);

template <class S> class EverySolid : public testing::Test {};
using AllSolids = testing::Types<Tet4, Tet10, Penta6, Pentac15, Hexe8, Hexec20, Hexec27>;
TYPED_TEST_SUITE(EverySolid, AllSolids);

// Points in and a little outside the reference domain.
template <class S> std::vector<Point<S::dim>> sample() {
  std::vector<Point<S::dim>> points;
  for (const double x : {-0.9, -0.35, 0.0, 0.2, 0.61, 1.05}) {
    for (const double y : {-0.8, 0.13, 0.47, 1.0}) {
      Point<S::dim> r;
      r[0] = x;
      if constexpr (S::dim >= 2) {
        r[1] = y;
      }
      if constexpr (S::dim == 3) {
        r[2] = 0.4 - 0.9 * x * y;
      }
      points.push_back(r);
    }
  }
  return points;
}

// The shape as data is the shape.
TYPED_TEST(EveryShape, has_a_reference_element) {
  using S = TypeParam;
  const ReferenceElement<S::dim>& element = as_reference_element<S>();
  ASSERT_EQ(element.nodes, S::nodes);
  EXPECT_EQ(element.quadratic, element.nodes > element.corners);
  EXPECT_EQ(element.centre(), centre<S>());
  for (int i = 0; i < S::nodes; ++i) {
    EXPECT_EQ(element.node_local_coordinates(i), node_local_coordinates<S>(i));
    if constexpr (S::dim > 1) { // its linear relative has the same corners
      const auto L = element.linear_element().N(node_local_coordinates<S>(i));
      EXPECT_EQ(L.size(), element.corners);
      EXPECT_TRUE(i >= element.corners || std::abs(L[i] - 1.0) < 1e-15);
    }
  }
  for (const auto& r : sample<S>()) {
    EXPECT_EQ(element.N(r), S::N(r));
    EXPECT_EQ(element.dN(r), S::dN(r));
    EXPECT_EQ(element.distance_outside(r), distance_outside<S>(r));
  }
}

TYPED_TEST(EveryShape, sums_to_one) {
  for (const auto& r : sample<TypeParam>()) {
    EXPECT_NEAR(TypeParam::N(r).sum(), 1.0, 1e-14);
    EXPECT_NEAR(TypeParam::dN(r).colwise().sum().cwiseAbs().maxCoeff(), 0.0, 1e-14);
  }
}

TYPED_TEST(EveryShape, is_one_at_its_node_and_zero_at_the_others) {
  for (int i = 0; i < TypeParam::nodes; ++i) {
    const Eigen::Matrix<double, TypeParam::nodes, 1> n =
        TypeParam::N(node_local_coordinates<TypeParam>(i));
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
      x += node_local_coordinates<TypeParam>(i) * TypeParam::N(r)[i];
      J += node_local_coordinates<TypeParam>(i) * TypeParam::dN(r).row(i);
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
    EXPECT_LE(distance_outside<TypeParam>(node_local_coordinates<TypeParam>(i)), 0.0);
  }
  EXPECT_LE(distance_outside<TypeParam>(centre<TypeParam>()), -0.25);
  const double simplex = TypeParam::domain == ReferenceDomain::tetrahedron ? 2.75 : 1.5;
  const bool oblique = TypeParam::domain == ReferenceDomain::triangle ||
                       TypeParam::domain == ReferenceDomain::tetrahedron ||
                       TypeParam::domain == ReferenceDomain::prism;
  EXPECT_NEAR(distance_outside<TypeParam>(Point<TypeParam::dim>::Constant(1.25)),
              oblique ? simplex : 0.25, 1e-15);
}

TYPED_TEST(EveryElement, agrees_with_the_library_table) {
  const base::ElementInfo& info = base::element_info(TypeParam::type);
  EXPECT_EQ(info.nodes, TypeParam::nodes);
  EXPECT_EQ(info.dim, TypeParam::dim);
  const int nodes = with_element_shape(TypeParam::type, []<ElementShape S>(S) { return S::nodes; });
  EXPECT_EQ(nodes, TypeParam::nodes);
}

// Every polynomial up to the order of the element, in real coordinates.
TYPED_TEST(EveryElement, is_complete) {
  using S = TypeParam;
  const int order = base::element_info(S::type).quadratic ? 2 : 1;
  const auto monomial = [](const Point<S::dim>& r, std::array<int, 3> p) {
    double value = 1.0;
    for (int k = 0; k < S::dim; ++k) {
      value *= std::pow(r[k], p[static_cast<std::size_t>(k)]);
    }
    return value;
  };
  for (int a = 0; a <= order; ++a) {
    for (int b = 0; a + b <= order; ++b) {
      for (int c = 0; a + b + c <= (S::dim == 3 ? order : 0); ++c) {
        Eigen::Matrix<double, S::nodes, 1> nodal;
        for (int i = 0; i < S::nodes; ++i) {
          nodal[i] = monomial(node_local_coordinates<S>(i), {a, b, c});
        }
        for (const auto& r : sample<S>()) {
          EXPECT_NEAR(S::N(r).dot(nodal), monomial(r, {a, b, c}), 1e-14) << a << b << c;
        }
      }
    }
  }
}

TYPED_TEST(EveryElement, edges_are_those_of_the_sides_and_mid_nodes_lie_on_them) {
  using S = TypeParam;
  const base::ElementInfo& info = base::element_info(S::type);
  for (int m = 0; m < edge_count(S::type); ++m) {
    const auto [a, b] = edge_corners(S::type, m);
    int sides = 0;
    for (int s = 0; s < info.sides; ++s) {
      const std::span<const int> local = side_nodes(S::type, s);
      const bool on_side = std::count(local.begin(), local.end(), a) == 1 &&
                           std::count(local.begin(), local.end(), b) == 1;
      sides += on_side ? 1 : 0;
    }
    EXPECT_EQ(sides, S::dim == 2 ? 1 : 2) << m;
    if (info.quadratic) {
      const Point<S::dim> mid = 0.5 * (node_local_coordinates<S>(a) + node_local_coordinates<S>(b));
      EXPECT_EQ((node_local_coordinates<S>(info.corners + m) - mid).norm(), 0.0) << m;
    }
  }
}

TYPED_TEST(EveryPlane, restricted_to_a_side_is_the_shape_of_the_side) {
  using Side = typename TypeParam::Side;
  for (int s = 0; s < base::element_info(TypeParam::type).sides; ++s) {
    const std::span<const int> local = side_nodes(TypeParam::type, s);
    ASSERT_EQ(local.size(), static_cast<std::size_t>(Side::nodes));
    for (const double t : {-0.7, 0.1, 0.85}) {
      const Eigen::Matrix<double, Side::nodes, 1> n = Side::N(Point<1>(t));
      Point<2> r = Point<2>::Zero();
      for (int i = 0; i < Side::nodes; ++i) {
        r += n[i] * node_local_coordinates<TypeParam>(local[static_cast<std::size_t>(i)]);
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

// The side's shape on the side's nodes, in their order, is the element's own on that side.
TYPED_TEST(EverySolid, restricted_to_a_side_is_the_shape_of_the_side) {
  using S = TypeParam;
  for (int s = 0; s < base::element_info(S::type).sides; ++s) {
    const std::span<const int> local = side_nodes(S::type, s);
    with_plane_shape(solid_side_type(S::type, s), [&]<PlaneShape Side>(Side) {
      ASSERT_EQ(local.size(), static_cast<std::size_t>(Side::nodes));
      EXPECT_EQ(side_corner_count(S::type, s),
                static_cast<std::size_t>(base::element_info(Side::type).corners));
      for (const Point<2>& t : sample<Side>()) {
        const Eigen::Matrix<double, Side::nodes, 1> n = Side::N(t);
        Point<3> r = Point<3>::Zero();
        Eigen::Matrix<double, S::nodes, 1> expected;
        expected.setZero();
        for (int i = 0; i < Side::nodes; ++i) {
          r += n[i] * node_local_coordinates<S>(local[static_cast<std::size_t>(i)]);
          expected[local[static_cast<std::size_t>(i)]] = n[i];
        }
        EXPECT_LT((S::N(r) - expected).cwiseAbs().maxCoeff(), 1e-13);
      }
    });
  }
}

// Exactly the nodes in the plane of a side belong to it, and its normal points away from the rest.
TYPED_TEST(EverySolid, sides_face_outwards_and_hold_all_their_nodes) {
  using S = TypeParam;
  for (int s = 0; s < base::element_info(S::type).sides; ++s) {
    const std::span<const int> local = side_nodes(S::type, s);
    const Point<3> at = node_local_coordinates<S>(local[0]);
    const Point<3> normal =
        (node_local_coordinates<S>(local[1]) - at).cross(node_local_coordinates<S>(local[2]) - at);
    for (int i = 0; i < S::nodes; ++i) {
      const bool listed = std::find(local.begin(), local.end(), i) != local.end();
      const double height = normal.dot(node_local_coordinates<S>(i) - at);
      EXPECT_EQ(listed, std::abs(height) < 1e-14) << s << ' ' << i;
      EXPECT_LT(height, 1e-14) << s << ' ' << i;
    }
  }
}

// Gauss: a third of the flux of x through the sides is the volume, that of the reference domain.
TYPED_TEST(EverySolid, sides_enclose_the_reference_volume) {
  using S = TypeParam;
  double volume = 0.0;
  for (const auto& q : quadrature<S>()) {
    volume += q.weight;
  }
  double flux = 0.0;
  for (int s = 0; s < base::element_info(S::type).sides; ++s) {
    const std::span<const int> local = side_nodes(S::type, s);
    with_plane_shape(solid_side_type(S::type, s), [&]<PlaneShape Side>(Side) {
      for (const auto& q : quadrature<Side>(5)) {
        Point<3> x = Point<3>::Zero();
        Eigen::Matrix<double, 3, 2> T;
        T.setZero();
        for (int i = 0; i < Side::nodes; ++i) {
          const Point<3> xi = node_local_coordinates<S>(local[static_cast<std::size_t>(i)]);
          x += Side::N(q.r)[i] * xi;
          T += xi * Side::dN(q.r).row(i);
        }
        flux += q.weight * x.dot(T.col(0).cross(T.col(1))) / 3.0;
      }
    });
  }
  EXPECT_NEAR(flux, volume, 1e-14);
}

// The functions reproduce the reference coordinates at each point, and their derivatives the
// slopes.
TYPED_TEST(EverySolid, tabulates_its_functions_at_the_points_of_a_rule) {
  using S = TypeParam;
  const ReferenceElement<3>& element = reference_element<3>(S::type);
  Eigen::Matrix3Xd x(3, S::nodes);
  for (int n = 0; n < S::nodes; ++n) {
    x.col(n) = node_local_coordinates<S>(n);
  }
  for (const int degree : {3, 9}) {
    const std::span<const QuadraturePoint<3>> rule = quadrature<S>(degree);
    const auto table = shape_functions_at_quadrature_points<3>(element, degree);
    ASSERT_EQ(table.size(), rule.size());
    for (std::size_t p = 0; p < rule.size(); ++p) {
      EXPECT_LT((x * table[p].N - rule[p].r).norm(), 1e-14);
      EXPECT_LT((x * table[p].dN - Eigen::Matrix3d::Identity()).norm(), 1e-13);
    }
  }
}

} // namespace
} // namespace spricka::shape::test_shape
