// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/element_side.hpp"

#include "shape/topology.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>

// Sides of plane elements and of solids: their shape functions, areas, boxes and nearest points.
namespace spricka::geometry::test_element_side {
namespace {

using base::ElementType;
using base::Vec2;
using base::Vec3;

class Random {
public:
  double number() { return std::uniform_real_distribution<double>(-1.0, 1.0)(engine_); }
  Vec3 vector() { return {number(), number(), number()}; }

private:
  std::mt19937 engine_{7};
};

/// An element alone in its mesh, with nodes where its reference element has them.
struct LoneElement {
  ElementType type;
  std::vector<base::NodeId> nodes;
  std::vector<Vec3> x;

  explicit LoneElement(ElementType type_) : type(type_) {
    if (base::element_info(type).dim == 2) {
      place<2>();
    } else {
      place<3>();
    }
  }
  [[nodiscard]] ElementSide side(int s) const { return {type, s, nodes, x}; }

private:
  template <int dim> void place() {
    const shape::ReferenceElement<dim>& element = shape::reference_element<dim>(type);
    for (int i = 0; i < element.nodes; ++i) {
      nodes.emplace_back(static_cast<std::size_t>(i));
      x.emplace_back(Vec3::Zero()).template head<dim>() = element.node_local_coordinates(i);
    }
  }
};

/// One element for each kind of side: edges of 2 and 3 nodes, faces of 3, 6, 4, 8 and 9.
constexpr std::array one_of_each{ElementType::trim3,  ElementType::trimc6, ElementType::tet4,
                                 ElementType::tet10,  ElementType::hexe8,  ElementType::hexec20,
                                 ElementType::hexec27};

// A skewed, stretched and a little curved side; edges stay in the plane.
ElementSide distorted_side(ElementType type, Random& random) {
  ElementSide side = LoneElement(type).side(0);
  const Vec3 across(2.0 * random.number(), 0.6, 0.4 * random.number());
  const Vec3 bend(1.0, 1.0, side.local_dim() == 1 ? 0.0 : 1.0);
  for (Eigen::Index i = 0; i < side.X.cols(); ++i) {
    const Vec2 r = side.node_local_coordinates(static_cast<int>(i));
    side.X.col(i) =
        r[0] * Vec3::UnitX() + r[1] * across + 0.02 * random.vector().cwiseProduct(bend);
  }
  return side;
}

// Local coordinates, up to a little outside the domain.
Vec2 some_coordinates(const ElementSide& side, Random& random) {
  const Vec2 r = 1.2 * Vec2(random.number(), side.local_dim() == 1 ? 0.0 : random.number());
  return side.domain() == shape::ReferenceDomain::triangle ? Vec2(0.5 * (r + Vec2::Ones())) : r;
}

double raster_distance(const ElementSide& side, const Vec3& x) {
  const int n = side.local_dim() == 1 ? 4000 : 300;
  double best = 1e300;
  for (int i = 0; i <= n; ++i) {
    const double a = static_cast<double>(i) / n;
    for (int j = 0; j <= (side.local_dim() == 1 ? 0 : n); ++j) {
      const double b = static_cast<double>(j) / n;
      Vec2 r(2.0 * a - 1.0, side.local_dim() == 1 ? 0.0 : 2.0 * b - 1.0);
      if (side.domain() == shape::ReferenceDomain::triangle) {
        r = {a * (1.0 - b), b};
      }
      best = std::min(best, (x - side.position(r)).norm());
    }
  }
  return best;
}

class EverySide : public testing::TestWithParam<ElementType> {
protected:
  Random random;
};

TEST_P(EverySide, has_one_function_for_each_node) {
  const ElementSide side = LoneElement(GetParam()).side(0);
  const auto count = static_cast<int>(side.nodes.size());
  for (int i = 0; i < count; ++i) {
    const SideValues N = side.N(side.node_local_coordinates(i));
    ASSERT_EQ(N.size(), count);
    EXPECT_LT((N - SideValues::Unit(count, i)).norm(), 1e-14);
    EXPECT_LT((side.position(side.node_local_coordinates(i)) - side.X.col(i)).norm(), 1e-14);
  }
}

TEST_P(EverySide, differentiates_as_differences_do) {
  constexpr double h = 1e-6;
  for (int trial = 0; trial < 10; ++trial) {
    const ElementSide side = distorted_side(GetParam(), random);
    const Vec2 r = some_coordinates(side, random);
    const SideDerivatives dN = side.dN(r);
    const SidePoint point = side.point(r);
    EXPECT_LT(dN.colwise().sum().norm(), 1e-13);
    for (int c = 0; c < side.local_dim(); ++c) {
      const Vec2 step = h * Vec2::Unit(c);
      EXPECT_LT((dN.col(c) - (side.N(r + step) - side.N(r - step)) / (2.0 * h)).norm(), 1e-8);
      const Vec3 tangent = (side.position(r + step) - side.position(r - step)) / (2.0 * h);
      EXPECT_LT((point.tangents.col(c) - tangent).norm(), 1e-8);
    }
    EXPECT_NEAR(point.normal().norm(), 1.0, 1e-14);
    EXPECT_LT((point.area_vector() - side.area_vector(r)).norm(), 1e-15);
    EXPECT_NEAR(point.normal().dot(point.tangents.col(0)), 0.0, 1e-14);
  }
}

TEST_P(EverySide, clamps_to_its_domain) {
  const ElementSide side = LoneElement(GetParam()).side(0);
  for (int trial = 0; trial < 200; ++trial) {
    const Vec2 r = some_coordinates(side, random);
    const Vec2 in = side.clamp_to_side(r);
    EXPECT_LE(side.distance_outside(in), 1e-15);
    EXPECT_LT((side.clamp_to_side(in) - in).norm(), 1e-15);
    if (side.distance_outside(r) <= 0.0) {
      EXPECT_EQ(in, r);
    }
  }
  EXPECT_LT(side.distance_outside(side.domain_centre()), 0.0);
}

// Points off a side and beyond its edges and corners by as much as a tie allows.
TEST_P(EverySide, finds_its_nearest_point) {
  for (int trial = 0; trial < 40; ++trial) {
    const ElementSide side = distorted_side(GetParam(), random);
    const double size = (side.X.colwise() - side.X.col(0)).colwise().norm().maxCoeff();
    const Vec3 off =
        random.vector().cwiseProduct(Vec3(1.0, 1.0, side.local_dim() == 1 ? 0.0 : 1.0));
    const Vec3 x = side.position(side.clamp_to_side(some_coordinates(side, random))) +
                   0.1 * size * off.normalized();
    const double raster = raster_distance(side, x);
    for (const ClampedFootPolicy border :
         {ClampedFootPolicy::compared, ClampedFootPolicy::replaced}) {
      const Vec2 r = side.nearest_local_coordinates(x, border);
      EXPECT_LT((side.clamp_to_side(r) - r).norm(), 1e-14);
      EXPECT_LT((x - side.position(r)).norm(), raster + 1e-9 * size) << trial;
    }
  }
}

TEST_P(EverySide, finds_its_own_points) {
  for (int trial = 0; trial < 40; ++trial) {
    const ElementSide side = distorted_side(GetParam(), random);
    const Vec2 r = side.clamp_to_side(some_coordinates(side, random));
    EXPECT_LT((side.nearest_local_coordinates(side.position(r)) - r).norm(), 1e-9);
  }
}

TEST_P(EverySide, without_area_is_met_in_its_centre) {
  ElementSide side = LoneElement(GetParam()).side(0);
  side.X.setZero();
  EXPECT_EQ(side.nearest_local_coordinates(Vec3::UnitX()), side.domain_centre());
  EXPECT_EQ(side.point(side.domain_centre()).normal(), Vec3::Zero());
  EXPECT_EQ(side.area(), 0.0);
}

TEST_P(EverySide, lies_in_its_box) {
  for (int trial = 0; trial < 20; ++trial) {
    const ElementSide side = distorted_side(GetParam(), random);
    const Box<3> box = side.bounding_box().grown(1e-14);
    for (int k = 0; k < 50; ++k) {
      EXPECT_TRUE(box.contains(side.position(side.clamp_to_side(some_coordinates(side, random)))));
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Geometry, EverySide, testing::ValuesIn(one_of_each), [](const auto& of) {
  return std::string(base::element_info(of.param).name);
});

// Area vectors of a closed surface add up to nothing, and x . a / dim to the volume.
TEST(ElementSide, SidesOfAnElementEncloseIt) {
  Random random;
  for (const auto& [type, volume] :
       {std::pair(ElementType::trim3, 0.5), std::pair(ElementType::trimc6, 0.5),
        std::pair(ElementType::quam4, 4.0), std::pair(ElementType::quamc8, 4.0),
        std::pair(ElementType::quamc9, 4.0), std::pair(ElementType::tet4, 1.0 / 6.0),
        std::pair(ElementType::tet10, 1.0 / 6.0), std::pair(ElementType::penta6, 1.0),
        std::pair(ElementType::pentac15, 1.0), std::pair(ElementType::hexe8, 8.0),
        std::pair(ElementType::hexec20, 8.0), std::pair(ElementType::hexec27, 8.0)}) {
    SCOPED_TRACE(base::element_info(type).name);
    LoneElement element(type);
    const int dim = base::element_info(type).dim;
    for (const double distortion : {0.0, 0.05}) {
      for (Vec3& x : element.x) {
        x.head(dim) += distortion * random.vector().head(dim);
      }
      Vec3 sum = Vec3::Zero();
      double enclosed = 0.0;
      for (int s = 0; s < base::element_info(type).sides; ++s) {
        const ElementSide side = element.side(s);
        EXPECT_EQ(side.local_dim(), dim - 1);
        EXPECT_EQ(side.corner_count(), static_cast<int>(shape::side_corner_count(type, s)));
        side.for_quadrature_points(9, [&](const Vec2& r, double weight) {
          sum += weight * side.area_vector(r);
          enclosed += weight * side.area_vector(r).dot(side.position(r)) / dim;
        });
      }
      EXPECT_LT(sum.norm(), 1e-13);
      if (distortion == 0.0) {
        EXPECT_NEAR(enclosed, volume, 1e-13);
      }
    }
  }
}

// An edge of three nodes is a parabola, y = x^2 / 4 on [-1, 1]: its length in closed form.
TEST(ElementSide, HasTheLengthOfAParabola) {
  ElementSide edge = LoneElement(ElementType::trimc6).side(0);
  edge.X.col(0) = Vec3(-1.0, 0.25, 0.0);
  edge.X.col(1) = Vec3(1.0, 0.25, 0.0);
  edge.X.col(2) = Vec3::Zero();
  EXPECT_NEAR(edge.area(31), std::sqrt(1.25) + 2.0 * std::asinh(0.5), 1e-14);
}

TEST(ElementSide, HasTheAreaOfAParallelogram) {
  for (const ElementType type : {ElementType::hexe8, ElementType::hexec20, ElementType::hexec27}) {
    ElementSide face = LoneElement(type).side(0);
    const Vec3 a(0.3, 0.1, -0.2);
    const Vec3 b(-0.1, 0.4, 0.5);
    for (Eigen::Index i = 0; i < face.X.cols(); ++i) {
      const Vec2 r = face.node_local_coordinates(static_cast<int>(i));
      face.X.col(i) = r[0] * a + r[1] * b;
    }
    EXPECT_NEAR(face.area(), 4.0 * a.cross(b).norm(), 1e-14);
    EXPECT_LT((face.point({0.3, 0.2}).normal() - a.cross(b).normalized()).norm(), 1e-14);
  }
}

// Places on the edges of faces are those of the curve through the edge's nodes.
TEST(ElementSide, EdgesOfFacesHaveTheirNodes) {
  Random random;
  for (const ElementType type : one_of_each) {
    const ElementSide face = distorted_side(type, random);
    for (int i = 0; i < face.corner_count() && face.local_dim() == 2; ++i) {
      EXPECT_LT((face.position(face.edge_coordinates(i, -1.0)) - face.X.col(i)).norm(), 1e-14);
      EXPECT_LT(
          (face.position(face.edge_coordinates(i, 1.0)) - face.X.col((i + 1) % face.corner_count()))
              .norm(),
          1e-14);
      if (face.is_quadratic()) {
        EXPECT_LT(
            (face.position(face.edge_coordinates(i, 0.0)) - face.X.col(face.corner_count() + i))
                .norm(),
            1e-14);
      }
    }
  }
}

} // namespace
} // namespace spricka::geometry::test_element_side
