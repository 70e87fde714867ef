// SPDX-License-Identifier: GPL-3.0-or-later
// Boxes in a tree against all boxes asked one by one; the signed distance of bodies with flat
// facets against closed forms.
#include "geometry/body_boundary.hpp"
#include "geometry/box_tree.hpp"
#include "geometry/triangle.hpp"

#include <cmath>
#include <limits>
#include <numbers>
#include <random>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

namespace spricka::geometry::test_box_tree {
namespace {

using base::Vec3;

template <class Dim> class BoxTrees : public testing::Test {
protected:
  static constexpr int dimension = Dim::value;
  using Point = typename Box<dimension>::Point;

  BoxTrees() {
    for (int i = 0; i < 500; ++i) {
      const Point low = random_point();
      // Points and flat boxes too.
      const double size = i % 5 == 0 ? 0.0 : 0.1;
      boxes.push_back({low, low + size * random_point().cwiseMax(i % 7 == 0 ? 0.0 : 0.3)});
    }
  }
  Point random_point() {
    Point x;
    for (int i = 0; i < dimension; ++i) {
      x[i] = at(random);
    }
    return x;
  }
  template <class Condition> std::vector<std::size_t> which(Condition&& condition) const {
    std::vector<std::size_t> found;
    for (std::size_t i = 0; i < boxes.size(); ++i) {
      if (condition(boxes[i])) {
        found.push_back(i);
      }
    }
    return found;
  }

  std::mt19937 random{2};
  std::uniform_real_distribution<double> at{0.0, 10.0};
  std::vector<Box<dimension>> boxes;
};

using Dimensions = testing::Types<std::integral_constant<int, 2>, std::integral_constant<int, 3>>;
TYPED_TEST_SUITE(BoxTrees, Dimensions);

TYPED_TEST(BoxTrees, FindsWhatAllBoxesAskedOneByOneGive) {
  constexpr int dim = TestFixture::dimension;
  const BoxTree<dim> tree(this->boxes);
  for (int i = 0; i < 50; ++i) {
    const auto x = this->random_point();
    const auto y = this->random_point();
    const Box<dim> asked{x, x + y.cwiseMin(2.0)};
    const auto contains = [&](const Box<dim>& box) { return box.contains(x); };
    EXPECT_EQ(tree.boxes_containing(x), this->which(contains));
    const auto meets = [&](const Box<dim>& box) { return box.meets(asked); };
    EXPECT_EQ(tree.boxes_intersecting(asked), this->which(meets));
    const auto near = [&](const Box<dim>& box) { return box.distance(x) <= 1.5; };
    EXPECT_EQ(tree.boxes_within(x, 1.5), this->which(near));
    const auto along = [&](const Box<dim>& box) {
      return box.grown(0.2 * box.diagonal()).meets_segment(x, y);
    };
    EXPECT_EQ(tree.boxes_meeting_segment(x, y, 0.2), this->which(along));
  }
}

TYPED_TEST(BoxTrees, SegmentsMeetABoxWhereTheirPointsDo) {
  constexpr int dim = TestFixture::dimension;
  for (const Box<dim>& box : this->boxes) {
    const auto from = this->random_point();
    const auto to = this->random_point();
    double least = std::numeric_limits<double>::infinity();
    constexpr int parts = 1000;
    for (int k = 0; k <= parts; ++k) {
      least = std::min(least, box.distance(from + k * (to - from) / parts));
    }
    EXPECT_TRUE(box.meets_segment(from, to) || least > 0.0);
    EXPECT_TRUE(!box.meets_segment(from, to) || least <= (to - from).norm() / parts);
    EXPECT_TRUE(box.meets_segment(from, box.high));
    EXPECT_TRUE(box.meets_segment(box.low, box.low)); // of no length
  }
}

TYPED_TEST(BoxTrees, VisitsByDistanceThenNumber) {
  constexpr int dim = TestFixture::dimension;
  this->boxes.insert(this->boxes.end(), this->boxes.begin(), this->boxes.begin() + 100); // twice
  const BoxTree<dim> tree(this->boxes);
  for (const double far : {1.0, 10.0, 1e6}) {
    for (int i = 0; i < 20; ++i) {
      const auto x = (far * this->random_point()).eval();
      std::vector<std::pair<double, std::size_t>> all;
      for (std::size_t k = 0; k < this->boxes.size(); ++k) {
        all.emplace_back(this->boxes[k].distance(x), k);
      }
      std::ranges::sort(all);
      std::vector<std::pair<double, std::size_t>> met;
      const auto visit = [&](double most) {
        return [&, most](std::size_t k) {
          met.emplace_back(this->boxes[k].distance(x), k);
          return most;
        };
      };
      tree.visit_nearest(x, visit(std::numeric_limits<double>::infinity()));
      EXPECT_EQ(met, all);
      met.clear();
      const double reach = all[50].first;
      tree.visit_nearest(x, visit(reach));
      std::erase_if(all, [&](const auto& box) { return box.first > reach; });
      EXPECT_EQ(met, all);
      met.clear();
      tree.visit_nearest(x, visit(reach), reach);
      EXPECT_EQ(met, all);
    }
  }
}

// What lies in the boxes: points and discs about their centres.
TYPED_TEST(BoxTrees, NearestOfAllIsThatOfTheLowestNumber) {
  constexpr int dim = TestFixture::dimension;
  this->boxes.insert(this->boxes.end(), this->boxes.begin(), this->boxes.begin() + 100); // twice
  const BoxTree<dim> tree(this->boxes);
  for (int i = 0; i < 200; ++i) {
    const auto x = (2.0 * this->random_point()).eval();
    const auto distance = [&](std::size_t k) {
      const Box<dim>& box = this->boxes[k];
      const double radius = 0.5 * (box.high - box.low).minCoeff();
      return std::max(0.0, (x - 0.5 * (box.low + box.high)).norm() - radius);
    };
    std::size_t best = 0;
    for (std::size_t k = 1; k < this->boxes.size(); ++k) {
      best = distance(k) < distance(best) ? k : best;
    }
    EXPECT_EQ(tree.nearest(x, distance), best);
  }
}

TYPED_TEST(BoxTrees, NothingIsFoundInAnEmptyTree) {
  constexpr int dim = TestFixture::dimension;
  const BoxTree<dim> tree;
  const auto x = this->random_point();
  EXPECT_TRUE(tree.boxes_containing(x).empty());
  EXPECT_TRUE(tree.boxes_within(x, 1e9).empty());
  tree.visit_nearest(x, [](std::size_t) -> double {
    ADD_FAILURE();
    return 0.0;
  });
  EXPECT_FALSE(tree.nearest(x, [](std::size_t) { return 0.0; }));
  // Boxes that are one point.
  const BoxTree<dim> points(std::vector<Box<dim>>(3, Box<dim>{x, x}));
  std::vector<std::size_t> met;
  points.visit_nearest(this->random_point(), [&](std::size_t i) {
    met.push_back(i);
    return 100.0;
  });
  EXPECT_EQ(met, (std::vector<std::size_t>{0, 1, 2}));
}

TEST(Triangle, NearestPointIsNearerThanAllOthers) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> at(-1.0, 1.0);
  const auto any = [&] { return Vec3(at(random), at(random), at(random)); };
  for (int i = 0; i < 300; ++i) {
    const std::array<Vec3, 3> t{any(), any(), any()};
    const Vec3 x = 2.0 * any();
    const NearestTrianglePoint found = nearest_point(x, t);
    double least = std::numeric_limits<double>::infinity();
    constexpr int parts = 60;
    for (int a = 0; a <= parts; ++a) {
      for (int b = 0; a + b <= parts; ++b) {
        const Vec3 y = t[0] + (a * (t[1] - t[0]) + b * (t[2] - t[0])) / parts;
        least = std::min(least, (y - x).norm());
      }
    }
    EXPECT_LE((found.x - x).norm(), least + 1e-14);
    EXPECT_GE((found.x - x).norm(), least - 0.1);
    if (found.corner >= 0) {
      EXPECT_EQ(found.x, t[static_cast<std::size_t>(found.corner)]);
    } else if (found.edge >= 0) {
      const Vec3& a = t[static_cast<std::size_t>(found.edge)];
      const Vec3& b = t[static_cast<std::size_t>((found.edge + 1) % 3)];
      EXPECT_NEAR((found.x - a).norm() + (b - found.x).norm(), (b - a).norm(), 1e-14);
      EXPECT_NEAR((x - found.x).dot(b - a), 0.0, 1e-13);
    } else {
      EXPECT_NEAR((x - found.x).cross((t[1] - t[0]).cross(t[2] - t[0])).norm(), 0.0, 1e-12);
    }
  }
}

std::vector<FlatBoundaryFacet> polygon(const std::vector<Vec3>& corners, std::size_t first = 0) {
  std::vector<FlatBoundaryFacet> facets;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const std::size_t next = (i + 1) % corners.size();
    facets.push_back({{corners[i], corners[next], Vec3::Zero()}, {first + i, first + next, 0}});
  }
  return facets;
}

std::vector<Vec3> circle(double radius, int count) {
  std::vector<Vec3> points;
  for (int i = 0; i < count; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / count;
    points.emplace_back(radius * std::cos(angle), radius * std::sin(angle), 0.0);
  }
  return points;
}

// Between two circles: the outer one anticlockwise, the inner one clockwise.
TEST(BodyBoundary, RingInThePlane) {
  constexpr int count = 400;
  std::vector<FlatBoundaryFacet> facets = polygon(circle(2.0, count));
  const std::vector<Vec3> inner = circle(1.0, count);
  const std::vector<FlatBoundaryFacet> hole =
      polygon({inner.rbegin(), inner.rend()}, static_cast<std::size_t>(count));
  facets.insert(facets.end(), hole.begin(), hole.end());
  const BodyBoundary body(2, facets);
  EXPECT_DOUBLE_EQ(body.box().low.x(), -2.0);
  EXPECT_DOUBLE_EQ(body.box().high.y(), 2.0);
  std::mt19937 random(4);
  std::uniform_real_distribution<double> at(-2.5, 2.5);
  for (int i = 0; i < 500; ++i) {
    const Vec3 x(at(random), at(random), 0.0);
    const double wanted = std::max(1.0 - x.norm(), x.norm() - 2.0);
    const auto found = body.signed_distance(x, 1.0);
    ASSERT_EQ(found.has_value(), wanted <= 1.0);
    if (found) {
      // An arc rises c^2 / 8R above its chord c.
      EXPECT_NEAR(found->distance, wanted, 1.01 * found->facet);
      const double radius = x.norm() < 1.5 ? 1.0 : 2.0;
      const double chord = 2.0 * radius * std::sin(std::numbers::pi / count);
      EXPECT_NEAR(found->facet, chord * chord / (8.0 * radius), 1e-3 * found->facet);
    }
  }
}

// Before a corner of 30 degrees the normal of one side alone tells the wrong side.
TEST(BodyBoundary, SharpCorners) {
  const double slope = std::tan(std::numbers::pi / 6.0);
  const BodyBoundary plane(2, polygon({Vec3::Zero(), Vec3(1.0, 0.0, 0.0), Vec3(1.0, slope, 0.0)}));
  for (int i = 0; i < 100; ++i) {
    const double angle = 13.0 / 12.0 * std::numbers::pi + 0.025 * (i - 50); // of both sides
    const Vec3 x = 0.1 * Vec3(std::cos(angle), std::sin(angle), 0.0);
    const auto found = plane.signed_distance(x, 1.0);
    ASSERT_TRUE(found);
    EXPECT_NEAR(found->distance, 0.1, 1e-14);
    EXPECT_EQ(found->facet, 0.0); // corners belong to the shape
  }
  EXPECT_FALSE(plane.signed_distance({-2.0, 0.0, 0.0}, 1.0));
  EXPECT_FALSE(BodyBoundary(2, {}).signed_distance(Vec3::Zero(), 1.0));
  EXPECT_FALSE(BodyBoundary(3, {}).signed_distance(Vec3::Zero(), 1.0));
}

// A tetrahedron: the largest of the distances from its planes inside, and by hand outside.
TEST(BodyBoundary, TetrahedronInSpace) {
  const std::array<Vec3, 4> p{Vec3(0.0, 0.0, 0.0), Vec3(3.0, 0.2, 0.0), Vec3(0.3, 1.0, 0.1),
                              Vec3(0.5, 0.4, 2.0)};
  const std::array<std::array<std::size_t, 3>, 4> faces{
      {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}};
  std::vector<FlatBoundaryFacet> facets;
  for (const auto& f : faces) {
    facets.push_back({{p[f[0]], p[f[1]], p[f[2]]}, f});
  }
  const BodyBoundary body(3, facets);
  std::mt19937 random(5);
  std::uniform_real_distribution<double> at(-1.0, 3.0);
  for (int i = 0; i < 1000; ++i) {
    const Vec3 x(at(random), at(random), at(random));
    double highest = -std::numeric_limits<double>::infinity(); // above the planes of the faces
    double least = std::numeric_limits<double>::infinity();
    for (const FlatBoundaryFacet& facet : facets) {
      const Vec3 n = (facet.x[1] - facet.x[0]).cross(facet.x[2] - facet.x[0]).normalized();
      highest = std::max(highest, n.dot(x - facet.x[0]));
      least = std::min(least, (nearest_point(x, facet.x).x - x).norm());
    }
    const auto found = body.signed_distance(x, 100.0);
    ASSERT_TRUE(found);
    EXPECT_NEAR(found->distance, highest < 0.0 ? highest : least, 1e-13);
    EXPECT_EQ(found->facet, 0.0);
  }
}

} // namespace
} // namespace spricka::geometry::test_box_tree
