// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/make_rows.hpp"
#include "contact/pair_points.hpp"
#include "model/model.hpp"
#include "two_blocks.hpp"
#include "two_rings.hpp"

#include <gtest/gtest.h>

namespace spricka::test_pair_points {
namespace {

using base::ElementType;

// Both surfaces of the blocks, the upper one from x = 0.3 to 1.45 on the lower one from 0 to 2;
// five elements against seven, so that no node meets another.
struct Overlap {
  model::Model model;
  contact::ContactSurface low, up;
};

Overlap overlap(ElementType type) {
  model::Model model = test::two_blocks({type, model::StressState::plane_strain, 5, 7, 0.3, 1.45});
  contact::ContactSurface low =
      contact::make_surface(model, model.mesh, test::face_set(model, "LO.YMAX"));
  contact::ContactSurface up =
      contact::make_surface(model, model.mesh, test::face_set(model, "UP.YMIN"));
  return {std::move(model), std::move(low), std::move(up)};
}

class MortarPoints : public testing::TestWithParam<ElementType> {};

// Of blocks that are 5 thick.
TEST_P(MortarPoints, WeightsSumToTheAreaOfTheOverlap) {
  const Overlap blocks = overlap(GetParam());
  for (const bool swapped : {false, true}) {
    const contact::MortarPoints all =
        swapped ? contact::mortar_points(blocks.up, blocks.low, std::nullopt)
                : contact::mortar_points(blocks.low, blocks.up, std::nullopt);
    ASSERT_TRUE(all.found);
    ASSERT_TRUE(all.trouble.empty()) << all.trouble;
    double paired = 0.0;
    double whole = 0.0;
    for (const contact::MortarPoint& p : all.points) {
      paired += p.weight;
    }
    for (const contact::SurfaceQuadraturePoint& p : all.surface) {
      whole += p.weight;
    }
    EXPECT_NEAR(paired, 5.0 * 1.15, 1e-12);
    EXPECT_NEAR(whole, 5.0 * (swapped ? 1.15 : 2.0), 1e-12);
  }
}

// A field that is linear on one surface and on the other: by the place of the points, and by the
// values that the nodes of either side give there.
TEST_P(MortarPoints, LinearFieldsAreIntegratedExactly) {
  const Overlap blocks = overlap(GetParam());
  const auto field = [](double x) { return 1.0 - 3.0 * x; };
  const auto at = [&](const geometry::ElementSide& facet, const base::Vec2& r) {
    const geometry::SideValues N = facet.N(r);
    double sum = 0.0;
    for (std::size_t i = 0; i < facet.nodes.size(); ++i) {
      sum +=
          N[static_cast<Eigen::Index>(i)] * field(blocks.model.mesh.x[facet.nodes[i].index()].x());
    }
    return sum;
  };
  const double exact = 5.0 * (1.15 - 1.5 * (1.45 * 1.45 - 0.3 * 0.3));
  double by_place = 0.0;
  double by_own = 0.0;
  double by_other = 0.0;
  for (const contact::MortarPoint& p :
       contact::mortar_points(blocks.low, blocks.up, std::nullopt).points) {
    by_place += p.weight * field(p.x.x());
    by_own += p.weight * at(blocks.low.facets[p.facet], p.r);
    by_other += p.weight * at(blocks.up.facets[p.target], p.s);
    EXPECT_NEAR((p.normal - base::Vec3::UnitY()).norm(), 0.0, 1e-14);
    EXPECT_NEAR((p.tangent[0] + base::Vec3::UnitX()).norm(), 0.0, 1e-14);
    EXPECT_EQ(p.gap, 0.0);
  }
  EXPECT_NEAR(by_place, exact, 1e-12);
  EXPECT_NEAR(by_own, exact, 1e-12);
  EXPECT_NEAR(by_other, exact, 1e-12);
}

// Whatever surfaces look like: a field that is one weighs as much as the points do.
TEST_P(MortarPoints, RowsAreAPartitionOfUnity) {
  const model::Model model = test::two_rings(16, 21, GetParam());
  const contact::ContactSurface own =
      contact::make_surface(model, model.mesh, model.contacts[0].slave);
  const contact::ContactSurface other =
      contact::make_surface(model, model.mesh, model.contacts[0].master);
  const contact::MortarPoints all = contact::mortar_points(own, other, 0.01);
  ASSERT_TRUE(all.found);
  double weight = 0.0;
  base::Vec3 normal = base::Vec3::Zero();
  for (const contact::MortarPoint& p : all.points) {
    weight += p.weight;
    normal += p.weight * p.normal;
  }
  double whole = 0.0;
  for (const contact::SurfaceQuadraturePoint& p : all.surface) {
    whole += p.weight;
  }
  double area = 0.0;
  double support = 0.0;
  double gap = 0.0;
  for (const auto& [node, row] : contact::integrate_mortar_rows(all, own.facets, other.facets, 1)) {
    area += row.normal.area;
    support += row.normal.whole;
    gap += row.normal.gap;
    EXPECT_EQ(row.tangent[0].area, row.normal.area);
    EXPECT_TRUE(row.tangent[1].weight.empty());
  }
  EXPECT_NEAR(area, weight, 1e-12 * weight);
  EXPECT_NEAR(support, whole, 1e-12 * whole);
  EXPECT_NEAR(gap, 0.01 * weight, 1e-13 * weight);
}

INSTANTIATE_TEST_SUITE_P(Types, MortarPoints,
                         testing::Values(ElementType::quam4, ElementType::quamc8,
                                         ElementType::trimc6));

geometry::ElementSide line_facet(const std::vector<std::size_t>& nodes) {
  static const std::vector<base::Vec3> anywhere(5, base::Vec3::Zero());
  std::vector<base::NodeId> of_element(6); // the mid node of its first side is the fourth
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    of_element[i < 2 ? i : i + 1] = base::NodeId(nodes[i]);
  }
  return {nodes.size() == 2 ? ElementType::trim3 : ElementType::trimc6, 0, of_element, anywhere};
}

// Rows do not ask where a point comes from: one of any direction pushes with its weight, and where
// it lies, on both sides.
TEST(MakeRows, APointPushesBothSidesAtItsPlace) {
  const std::vector<geometry::ElementSide> own{line_facet({0, 1, 2})};
  const std::vector<geometry::ElementSide> other{line_facet({3, 4})};
  const std::array<double, 5> place{-1.0, 1.0, 0.0, -1.0, 1.0}; // reference coordinates of nodes
  contact::MortarPoint p;
  p.r = {0.3, 0.0};
  p.s = {-0.6, 0.0};
  p.normal = base::Vec3(1.0, 2.0, -2.0) / 3.0;
  p.tangent = {base::Vec3(2.0, 1.0, 2.0) / 3.0, base::Vec3(-2.0, 2.0, 1.0) / 3.0};
  p.weight = 2.5;
  p.gap = -0.1;
  contact::MortarPoints all;
  all.points = {p};
  const contact::RowsByNode rows = contact::integrate_mortar_rows(all, own, other, 2);
  base::Vec3 left = base::Vec3::Zero();
  base::Vec3 right = base::Vec3::Zero();
  double left_at = 0.0;
  double right_at = 0.0;
  double gap = 0.0;
  std::array<base::Vec3, 2> slip{base::Vec3::Zero(), base::Vec3::Zero()};
  for (const auto& [node, row] : rows) {
    EXPECT_GT(row.normal.area, 0.0);
    gap += row.normal.gap;
    for (const auto& [n, w] : row.normal.weight) {
      (n.index() < 3 ? left : right) += w;
      (n.index() < 3 ? left_at : right_at) += w.dot(p.normal) * place[n.index()];
    }
    for (std::size_t t = 0; t < 2; ++t) {
      for (const auto& [n, w] : row.tangent[t].weight) {
        slip[t] += n.index() < 3 ? base::Vec3::Zero() : w;
      }
    }
  }
  EXPECT_LT((left + 2.5 * p.normal).norm(), 1e-14);
  EXPECT_LT((right - 2.5 * p.normal).norm(), 1e-14);
  EXPECT_NEAR(left_at, -2.5 * 0.3, 1e-14);
  EXPECT_NEAR(right_at, 2.5 * -0.6, 1e-14);
  EXPECT_NEAR(gap, -0.25, 1e-15);
  for (std::size_t t = 0; t < 2; ++t) {
    EXPECT_LT((slip[t] - 2.5 * p.tangent[t]).norm(), 1e-14);
  }
}

// An end that covers a sliver of an edge: its row goes to the neighbour, nothing is lost.
TEST(MakeRows, SliversJoinTheirNeighbours) {
  const std::vector<geometry::ElementSide> own{line_facet({0, 1}), line_facet({1, 2})};
  contact::MortarPoints all;
  for (const std::size_t facet : {std::size_t{0}, std::size_t{1}}) {
    for (const double r : {-0.5, 0.5}) {
      all.surface.push_back({facet, {r, 0.0}, 1.0});
    }
  }
  for (const auto& [facet, r, weight] :
       {std::tuple(std::size_t{0}, -0.5, 1.0), std::tuple(std::size_t{0}, 0.5, 1.0),
        std::tuple(std::size_t{1}, -0.9, 0.1)}) {
    contact::MortarPoint p;
    p.facet = facet;
    p.r = {r, 0.0};
    p.weight = weight;
    p.normal = base::Vec3::UnitY();
    all.points.push_back(p);
  }
  contact::RowsByNode rows = contact::integrate_mortar_rows(all, own, {}, 1);
  const contact::NodeOrder order{
      {base::NodeId(std::size_t{0}), base::NodeId(std::size_t{1}), base::NodeId(std::size_t{2})},
      false};
  EXPECT_EQ(contact::merge_slivers(order, rows), 1);
  contact::PairConstraints pair;
  contact::append_rows(order, rows, 1, pair);
  ASSERT_EQ(pair.normal.size(), 2u);
  ASSERT_EQ(pair.tangent.size(), 2u);
  EXPECT_NEAR(pair.normal[0].area + pair.normal[1].area, 2.1, 1e-14);
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_EQ(pair.tangent[i].normal, static_cast<int>(i));
    EXPECT_EQ(pair.tangent[i].node, pair.normal[i].node);
    EXPECT_EQ(pair.normal[i].normal, -1);
  }
}

} // namespace
} // namespace spricka::test_pair_points
