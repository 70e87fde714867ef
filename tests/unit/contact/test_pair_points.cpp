// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/make_rows.hpp"
#include "contact/pair_points.hpp"
#include "contact/space/frames.hpp"
#include "model/model.hpp"
#include "two_blocks.hpp"
#include "two_rings.hpp"

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

namespace spricka::test_pair_points {
namespace {

using base::ElementType;

// Both surfaces of the blocks, the upper one from x = 0.3 to 1.45 on the lower one from 0 to 2;
// five elements against seven, so that no node meets another.
struct Overlap {
  model::Model model;
  contact::PairConstraints pair;
};

Overlap overlap(ElementType type, bool swapped) {
  Overlap blocks{test::two_blocks({type, model::StressState::plane_strain, 5, 7, 0.3, 1.45}), {}};
  contact::ContactSurface low = contact::make_contact_surface(
      blocks.model, blocks.model.mesh, test::face_set(blocks.model, "LO.YMAX"));
  contact::ContactSurface up = contact::make_contact_surface(
      blocks.model, blocks.model.mesh, test::face_set(blocks.model, "UP.YMIN"));
  blocks.pair.contact = std::move(swapped ? up : low);
  blocks.pair.target = std::move(swapped ? low : up);
  return blocks;
}

// What all elements of the contact surface meet together.
contact::OppositePointsOfElement projected(const contact::PairConstraints& pair) {
  contact::OppositePointsOfElement all;
  const contact::ElementProjector project = contact::make_target_projector(pair);
  for (const contact::HatElement& element : pair.contact.elements) {
    const contact::OppositePointsOfElement one = project(element);
    EXPECT_TRUE(one.trouble.empty()) << one.trouble;
    all.points.insert(all.points.end(), one.points.begin(), one.points.end());
    all.whole += one.whole;
  }
  return all;
}

class PairPoints : public testing::TestWithParam<ElementType> {};

// Of blocks that are 5 thick.
TEST_P(PairPoints, WeightsSumToTheAreaOfTheOverlap) {
  for (const bool swapped : {false, true}) {
    const Overlap blocks = overlap(GetParam(), swapped);
    const contact::OppositePointsOfElement all = projected(blocks.pair);
    ASSERT_FALSE(all.points.empty());
    double paired = 0.0;
    for (const contact::PairPoint& p : all.points) {
      paired += p.weight;
      EXPECT_NEAR(p.hat.sum(), 1.0, 1e-14);
      EXPECT_GE(p.hat.minCoeff(), 0.0);
    }
    EXPECT_NEAR(paired, 5.0 * 1.15, 1e-12);
    EXPECT_NEAR(all.whole.sum(), 5.0 * (swapped ? 1.15 : 2.0), 1e-12);
  }
}

// A field that is linear on one surface and on the other: by the place of the points, and by the
// values that the nodes of either side give there.
TEST_P(PairPoints, LinearFieldsAreIntegratedExactly) {
  const Overlap blocks = overlap(GetParam(), false);
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
  const contact::SurfaceFrames frames(blocks.pair.contact);
  const double exact = 5.0 * (1.15 - 1.5 * (1.45 * 1.45 - 0.3 * 0.3));
  double by_place = 0.0;
  double by_own = 0.0;
  double by_other = 0.0;
  for (const contact::PairPoint& p : projected(blocks.pair).points) {
    by_place += p.weight * field(p.x.x());
    by_own += p.weight * at(blocks.pair.contact.facets[p.facet], p.r);
    by_other += p.weight * at(blocks.pair.target.facets[p.target], p.s);
    EXPECT_NEAR((p.normal - base::Vec3::UnitY()).norm(), 0.0, 1e-14);
    EXPECT_NEAR((frames.at(0, p.normal)[1] + base::Vec3::UnitX()).norm(), 0.0, 1e-14);
    EXPECT_EQ(p.gap, 0.0);
  }
  EXPECT_NEAR(by_place, exact, 1e-12);
  EXPECT_NEAR(by_own, exact, 1e-12);
  EXPECT_NEAR(by_other, exact, 1e-12);
}

// Whatever surfaces look like: a field that is one weighs as much as the points do.
TEST_P(PairPoints, RowsAreAPartitionOfUnity) {
  const model::Model model = test::two_rings(16, 21, GetParam());
  contact::PairConstraints pair;
  pair.contact = contact::make_contact_surface(model, model.mesh, model.contacts[0].slave);
  pair.target = contact::make_contact_surface(model, model.mesh, model.contacts[0].master);
  double weight = 0.0;
  for (const contact::PairPoint& p : projected(pair).points) {
    weight += p.weight;
  }
  contact::fill_mortar_rows(pair, contact::make_target_projector(pair),
                            {.declared_gap = 0.01, .tangents = true});
  ASSERT_TRUE(pair.found);
  ASSERT_EQ(pair.tangent.size(), pair.normal.size());
  double area = 0.0;
  double gap = 0.0;
  for (std::size_t i = 0; i < pair.normal.size(); ++i) {
    area += pair.normal[i].area;
    gap += pair.normal[i].gap;
    EXPECT_EQ(pair.tangent[i].area, pair.normal[i].area);
  }
  EXPECT_NEAR(area, weight, 1e-12 * weight);
  EXPECT_NEAR(gap, 0.01 * weight, 1e-13 * weight);
}

INSTANTIATE_TEST_SUITE_P(Types, PairPoints,
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

// A contact surface of straight facets one behind the other, at no place in particular.
contact::ContactSurface line_of(const std::vector<std::vector<std::size_t>>& facets) {
  contact::ContactSurface surface;
  for (const std::vector<std::size_t>& nodes : facets) {
    const geometry::ElementSide& facet = surface.facets.emplace_back(line_facet(nodes));
    for (const contact::HatNodes& hats : contact::hat_elements(facet)) {
      surface.elements.push_back({surface.facets.size() - 1, hats});
    }
    contact::Edge& edge = surface.plane.edges.emplace_back();
    edge.count = static_cast<int>(nodes.size());
    std::ranges::copy(facet.nodes, edge.nodes.begin());
  }
  surface.part.assign(facets.size(), 0);
  surface.rounds.resize(1);
  surface.plane.chains = {{0, facets.size(), false}};
  return surface;
}

// Rows do not ask where a point comes from: one of any direction pushes with its weight, and where
// it lies, on both sides.
TEST(MakeRows, APointPushesBothSidesAtItsPlace) {
  contact::PairConstraints pair;
  pair.contact = line_of({{0, 1, 2}});
  pair.target = line_of({{3, 4}});
  const std::array<double, 5> place{-1.0, 1.0, 0.0, -1.0, 1.0}; // reference coordinates of nodes
  contact::PairPoint p;
  p.r = {0.3, 0.0};
  p.s = {-0.6, 0.0};
  p.hat = {0.7, 0.3, 0.0};
  p.normal = base::Vec3(1.0, 2.0, -2.0) / 3.0;
  p.weight = 2.5;
  p.gap = -0.1;
  contact::fill_mortar_rows(pair,
                            [&](const contact::HatElement& element) {
                              contact::OppositePointsOfElement met;
                              if (element.node[0] == 2) { // the half behind the mid node
                                met.points = {p};
                                met.whole = p.weight * p.hat;
                              }
                              return met;
                            },
                            {.declared_gap = {}, .tangents = true});
  base::Vec3 left = base::Vec3::Zero();
  base::Vec3 right = base::Vec3::Zero();
  base::Vec3 slip = base::Vec3::Zero();
  double left_at = 0.0;
  double right_at = 0.0;
  double gap = 0.0;
  ASSERT_EQ(pair.normal.size(), 2u);
  ASSERT_EQ(pair.tangent.size(), 2u);
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_GT(pair.normal[i].area, 0.0);
    gap += pair.normal[i].gap;
    for (const contact::RowEntry& entry : pair.normal[i].entries) {
      const bool own = entry.node.index() < 3;
      (own ? left : right) += entry.weight;
      (own ? left_at : right_at) += entry.weight.dot(p.normal) * place[entry.node.index()];
    }
    for (const contact::RowEntry& entry : pair.tangent[i].entries) {
      slip += entry.node.index() < 3 ? base::Vec3(base::Vec3::Zero()) : entry.weight;
    }
  }
  EXPECT_LT((left + 2.5 * p.normal).norm(), 1e-14);
  EXPECT_LT((right - 2.5 * p.normal).norm(), 1e-14);
  EXPECT_NEAR(left_at, -2.5 * 0.3, 1e-14);
  EXPECT_NEAR(right_at, 2.5 * -0.6, 1e-14);
  EXPECT_NEAR(gap, -0.25, 1e-15);
  EXPECT_LT((slip - 2.5 * base::Vec3::UnitZ().cross(p.normal)).norm(), 1e-14);
}

// An end that covers a sliver of an edge: its row goes to the neighbour, nothing is lost.
TEST(MakeRows, SliversJoinTheirNeighbours) {
  contact::PairConstraints pair;
  pair.contact = line_of({{0, 1}, {1, 2}});
  contact::fill_mortar_rows(
      pair,
      [&](const contact::HatElement& element) {
        contact::OppositePointsOfElement met;
        met.whole = {1.0, 1.0, 0.0};
        const bool first = element.facet == 0;
        for (const double r : first ? std::vector{-0.5, 0.5} : std::vector{-0.9}) {
          contact::PairPoint& p = met.points.emplace_back();
          p.facet = element.facet;
          p.r = {r, 0.0};
          p.hat = {0.5 * (1.0 - r), 0.5 * (1.0 + r), 0.0};
          p.weight = first ? 1.0 : 0.1;
          p.normal = base::Vec3::UnitY();
        }
        return met;
      },
      {.declared_gap = {}, .tangents = true});
  EXPECT_EQ(pair.merged, 1);
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
