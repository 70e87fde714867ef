// SPDX-License-Identifier: GPL-3.0-or-later
// Rigid targets in space, rows on round surfaces, edges where one surface ends, bodies that slide.
#include "contact/pairing.hpp"
#include "contact/recovery.hpp"
#include "contact/slide.hpp"
#include "contact/survey.hpp"
#include "model/model.hpp"
#include "stacked_solids.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <set>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

namespace spricka::test_space_limits {
namespace {

using base::ElementType;
using base::Vec3;

contact::PairConstraints pair_of(const model::Model& model) {
  return contact::build_pair_constraints(model, model.mesh, model.contacts[0]);
}

base::Vector field(const model::Mesh& mesh,
                   const std::function<Vec3(const Vec3&, base::NetId)>& u) {
  base::Vector all(3 * static_cast<Eigen::Index>(mesh.node_count()));
  for (std::size_t n = 0; n < mesh.node_count(); ++n) {
    all.segment<3>(3 * static_cast<Eigen::Index>(n)) = u(mesh.x[n], mesh.node_net[n]);
  }
  return all;
}

double opening(const contact::ConstraintRow& row, const base::Vector& u) {
  double g = 0.0;
  for (const contact::RowEntry& entry : row.entries) {
    g += entry.weight.dot(u.segment<3>(3 * static_cast<Eigen::Index>(entry.node.index())));
  }
  return g;
}

const base::NetId up{std::size_t{0}};

model::Model block_on(model::RigidTarget rigid) {
  test::StackSpec spec;
  spec.upper_type = ElementType::tet10;
  model::Model model = test::stacked_solids(spec);
  model.rigids = {std::move(rigid)};
  model.contacts[0].master = {};
  model.contacts[0].rigid = base::RigidId(std::size_t{0});
  model.contacts[0].gap.reset();
  return model;
}

TEST(RigidInSpace, PlaneMeetsAllOfABlockAtItsDistance) {
  model::RigidTarget floor;
  floor.shape = model::RigidTargetShape::plane;
  floor.first = {1.0, 2.0, -0.25};
  floor.second = {1.0, 2.0, 5.0};
  const model::Model model = block_on(floor);
  const contact::PairConstraints pair = pair_of(model);
  ASSERT_TRUE(pair.found);
  const base::Vector down =
      field(model.mesh, [](const Vec3&, base::NetId) { return Vec3(0.3, -0.2, -1.0); });
  double area = 0.0;
  for (const contact::ConstraintRow& row : pair.normal) {
    area += row.area;
    EXPECT_NEAR(row.gap, 0.25 * row.area, 1e-12);
    EXPECT_NEAR(opening(row, down), -row.area, 1e-12);
  }
  EXPECT_NEAR(area, 36.0, 1e-10);
  EXPECT_TRUE(pair.sharp_ends.empty());
  const contact::GapSurvey seen = contact::survey_gaps(pair.contact, *pair.rigid);
  EXPECT_NEAR(seen.gap_low, 0.25, 1e-12);
  EXPECT_NEAR(seen.gap_high, 0.25, 1e-12);
}

TEST(RigidInSpace, BallIsMetByItsDistance) {
  model::RigidTarget ball;
  ball.shape = model::RigidTargetShape::sphere;
  ball.first = {0.0, 0.0, -50.0};
  ball.radius = 50.0;
  const model::Model model = block_on(ball);
  const contact::GapSurvey seen = contact::survey_gaps(pair_of(model).contact, ball);
  EXPECT_NEAR(seen.gap_low, 0.0, 1e-3);
  // the farthest points of the rule are a little within the corners
  EXPECT_NEAR(seen.gap_high, std::hypot(50.0, 3.0 * std::sqrt(2.0)) - 50.0, 0.03);
  EXPECT_LT(seen.gap_high, std::hypot(50.0, 3.0 * std::sqrt(2.0)) - 50.0);
}

TEST(RigidInSpace, AConeWithoutTheBodyInItIsNotMet) {
  model::RigidTarget cone;
  cone.shape = model::RigidTargetShape::cone;
  cone.first = {0.0, 0.0, 40.0};
  cone.second = {0.0, 0.0, 80.0};
  cone.radius = 1.0;
  cone.second_radius = 2.0;
  EXPECT_FALSE(pair_of(block_on(cone)).found);
}

// Both blocks bent round the axis y at z = -radius: surfaces of cylinders.
model::Model bent_solids(const test::StackSpec& spec, double radius) {
  model::Model model = test::stacked_solids(spec);
  for (Vec3& x : model.mesh.x) {
    const double angle = x.x() / radius;
    x = {(radius + x.z()) * std::sin(angle), x.y(), (radius + x.z()) * std::cos(angle) - radius};
  }
  return model;
}

class RoundRows : public testing::TestWithParam<std::tuple<ElementType, ElementType>> {};

// A shaft that spins in its bore closes nothing (|G r| over |G e|).
TEST_P(RoundRows, SpinClosesNothing) {
  test::StackSpec spec;
  spec.upper_type = std::get<0>(GetParam());
  spec.lower_type = std::get<1>(GetParam());
  spec.turn = 0.0;
  const double radius = 12.0;
  const model::Model model = bent_solids(spec, radius);
  const contact::PairConstraints pair = pair_of(model);
  ASSERT_TRUE(pair.found) << pair.trouble;
  ASSERT_TRUE(pair.contact.rounds[0].has_value());
  EXPECT_EQ(pair.contact.rounds[0]->kind, contact::AnalyticShapeKind::cylinder);
  const base::Vector spin = field(model.mesh, [&](const Vec3& x, base::NetId net) {
    return net == up ? Vec3(Vec3::UnitY().cross(Vec3(x.x(), 0.0, x.z() + radius)) / radius)
                     : Vec3(Vec3::Zero());
  });
  const base::Vector lift = field(model.mesh, [&](const Vec3&, base::NetId net) {
    return net == up ? Vec3(Vec3::UnitZ()) : Vec3(Vec3::Zero());
  });
  double turned = 0.0;
  double lifted = 0.0;
  for (const contact::ConstraintRow& row : pair.normal) {
    turned = std::max(turned, std::abs(opening(row, spin)));
    lifted = std::max(lifted, std::abs(opening(row, lift)));
  }
  EXPECT_LT(turned, 1e-10 * lifted);
}

INSTANTIATE_TEST_SUITE_P(Types, RoundRows,
                         testing::Values(std::tuple(ElementType::hexec20, ElementType::hexec20),
                                         std::tuple(ElementType::hexec27, ElementType::tet10),
                                         std::tuple(ElementType::tet10, ElementType::hexec20)));

TEST(SharpEdges, TheFootOfABlockIsOneAndAnyNodeOfItsRim) {
  for (const bool upper_is_slave : {true, false}) {
    test::StackSpec spec;
    spec.upper_is_slave = upper_is_slave;
    spec.lower_cells = upper_is_slave ? 6 : 4;
    spec.upper_cells = upper_is_slave ? 4 : 6;
    const contact::PairConstraints pair = pair_of(test::stacked_solids(spec));
    ASSERT_EQ(pair.sharp_ends.size(), 1U);
    EXPECT_GE(pair.sharp_ends[0].nodes.size(), 16U);
  }
}

TEST(SharpEdges, SurfacesThatEndTogetherHaveNone) {
  test::StackSpec spec;
  spec.upper_size = 10.0;
  spec.turn = 0.0;
  EXPECT_TRUE(pair_of(test::stacked_solids(spec)).sharp_ends.empty());
}

class Slides : public testing::Test {
protected:
  contact::SlideMeasures slide(const std::function<Vec3(const Vec3&)>& of_upper) const {
    const base::Vector u = field(model.mesh, [&](const Vec3& x, base::NetId net) {
      return net == up ? of_upper(x) : Vec3(Vec3::Zero());
    });
    return contact::measure_slide(
        pair,
        base::Vector::Ones(static_cast<Eigen::Index>(pair.normal.size() + pair.tangent.size())), u);
  }
  model::Model model = test::stacked_solids({});
  contact::PairConstraints pair = pair_of(model);
};

TEST_F(Slides, AShiftIsAWayAndNoMisfit) {
  const contact::SlideMeasures s = slide([](const Vec3&) { return Vec3(0.3, 0.4, -1e-3); });
  EXPECT_NEAR(s.way, 0.5, 1e-12);
  EXPECT_NEAR(s.pressed, 6.0, 1e-9);
  EXPECT_NEAR(s.facet, 10.0 / 6.0, 1e-9);
  EXPECT_LT(s.misfit, 1e-12);
  EXPECT_EQ(s.unsupported_part, 0.0);
}

TEST_F(Slides, OffTheEdgeTheForceIsLost) {
  // The foot is turned by 0.35: half of it stands beyond the edge of a block 10 wide.
  const contact::SlideMeasures s = slide([](const Vec3&) { return Vec3(5.0, 0.0, 0.0); });
  EXPECT_NEAR(s.unsupported_part, 0.5, 0.02);
}

TEST_F(Slides, AShiftOnATurnedBodyIsAMisfitThatNoRowCounts) {
  const double turn = 0.02;
  const double shift = 0.3;
  const base::Vector u = field(model.mesh, [&](const Vec3& x, base::NetId net) {
    return Vec3(turn * x.z() + (net == up ? shift : 0.0), 0.0, -turn * x.x());
  });
  const contact::SlideMeasures s = contact::measure_slide(
      pair, base::Vector::Ones(static_cast<Eigen::Index>(pair.normal.size())), u);
  EXPECT_NEAR(s.misfit, shift * turn, 0.05 * shift * turn);
  EXPECT_NEAR(s.way, shift, 1e-6);
}

// Pressure on a foot 10 wide: what it goes up and down by counts, a rise toward an edge does not.
TEST(Unrest, IsNotTheCurveOfAPressureThatRisesToAnEdge) {
  test::StackSpec spec;
  spec.upper_type = spec.lower_type = ElementType::tet10;
  const model::Model model = test::stacked_solids(spec);
  const contact::PairConstraints pair = pair_of(model);
  std::set<base::NodeId> corners;
  for (const geometry::ElementSide& face : pair.contact.facets) {
    corners.insert(face.nodes.begin(), face.nodes.begin() + 3);
  }
  double far = 0.0; // of the foot along x
  for (const contact::MultiplierFunction& function : pair.functions) {
    far = std::max(far, model.mesh.x[function.node.index()].x());
  }
  const auto unrest_of = [&](const std::function<double(double, bool)>& p) {
    const auto rows = static_cast<Eigen::Index>(pair.normal.size());
    base::Vector lambda = base::Vector::Ones(rows);
    for (const contact::MultiplierFunction& function : pair.functions) {
      const auto row = static_cast<std::size_t>(function.row);
      const double x = model.mesh.x[function.node.index()].x();
      lambda[static_cast<Eigen::Index>(row)] = p(x / far, corners.contains(function.node));
    }
    return contact::recover_pressure(pair, lambda, base::Vector::Zero(rows),
                                     std::vector<bool>(pair.normal.size(), true), false)
        .unrest;
  };
  EXPECT_LT(unrest_of([](double x, bool) { return 1.0 + x * x * x * x; }), 0.01);
  EXPECT_GT(unrest_of([](double, bool corner) { return corner ? 1.2 : 0.8; }), 0.05);
}

class NodePairs : public testing::TestWithParam<ElementType> {};

TEST_P(NodePairs, OfAUniformPressureAreTheSameEverywhere) {
  test::StackSpec spec;
  spec.upper_type = GetParam();
  spec.lower_type = GetParam();
  spec.upper_size = 10.0;
  spec.upper_cells = spec.lower_cells = 3;
  spec.turn = 0.0;
  model::Model model = test::stacked_solids(spec);
  model.contacts[0].pairing = model::PairingMethod::node;
  const contact::PairConstraints pair = pair_of(model);
  ASSERT_TRUE(pair.trouble.empty()) << pair.trouble;
  // The forces of a pressure of 2: what it puts on each node through the shape functions.
  std::map<base::NodeId, double> force;
  for (const geometry::ElementSide& face : pair.contact.facets) {
    const double area = face.area();
    const std::size_t n = face.nodes.size();
    for (std::size_t i = 0; i < n; ++i) {
      const double share = n == 9   ? (i < 4   ? 1.0 / 36.0
                                       : i < 8 ? 1.0 / 9.0
                                               : 4.0 / 9.0)
                           : n == 6 ? (i < 3 ? 0.0 : 1.0 / 3.0)
                                    : 1.0 / static_cast<double>(n);
      force[face.nodes[i]] += 2.0 * share * area;
    }
  }
  base::Vector lambda(static_cast<Eigen::Index>(pair.normal.size()));
  std::vector<bool> closed;
  for (std::size_t r = 0; r < pair.normal.size(); ++r) {
    lambda[static_cast<Eigen::Index>(r)] = force.at(pair.normal[r].node) / pair.normal[r].area;
    closed.push_back(force.at(pair.normal[r].node) > 0.0);
  }
  const contact::PairPressure p =
      contact::recover_pressure(pair, lambda, base::Vector::Zero(lambda.size()), closed, false);
  EXPECT_NEAR(p.force_on_slave.norm(), 200.0, 1e-9);
  for (const contact::NodePressure& node : p.nodes) {
    EXPECT_NEAR(node.p_lumped, 2.0, 1e-12);
  }
}

INSTANTIATE_TEST_SUITE_P(Types, NodePairs,
                         testing::Values(ElementType::hexec27, ElementType::hexe8,
                                         ElementType::tet10));

TEST(NodePairsInSpace, AreRefusedWhereAPressurePullsAtCornersOrNodesDoNotMatch) {
  test::StackSpec spec;
  spec.upper_size = 10.0;
  spec.upper_cells = spec.lower_cells = 3;
  spec.turn = 0.0;
  model::Model model = test::stacked_solids(spec);
  model.contacts[0].pairing = model::PairingMethod::node;
  EXPECT_NE(pair_of(model).trouble.find("8 nodes"), std::string::npos);
  spec.upper_type = spec.lower_type = ElementType::hexec27;
  spec.upper_cells = 4;
  model = test::stacked_solids(spec);
  model.contacts[0].pairing = model::PairingMethod::node;
  EXPECT_NE(pair_of(model).trouble.find("opposite each slave node"), std::string::npos);
}

// Corners alone carry a pressure: fewer rows, the same forces for a constant pressure.
TEST(CornerMultipliers, HaveOneRowForEachCorner) {
  test::StackSpec spec;
  spec.turn = 0.0;
  model::Model model = test::stacked_solids(spec);
  model.contacts[0].multiplier = model::MultiplierNodes::corners;
  const contact::PairConstraints pair = pair_of(model);
  EXPECT_EQ(pair.normal.size(), 25U); // 4 x 4 faces of the foot
  double area = 0.0;
  for (const contact::ConstraintRow& row : pair.normal) {
    area += row.area;
  }
  EXPECT_NEAR(area, 36.0, 1e-10);
  const auto n = static_cast<Eigen::Index>(pair.normal.size());
  const contact::PairPressure p =
      contact::recover_pressure(pair, base::Vector::Constant(n, 2.0), base::Vector::Zero(n),
                                std::vector<bool>(pair.normal.size(), true), false);
  EXPECT_NEAR(p.force_on_slave.z(), 72.0, 1e-9);
  EXPECT_EQ(p.triangles.size(), 32U);
  for (const contact::NodePressure& node : p.nodes) {
    EXPECT_NEAR(node.p_lumped, 2.0, 1e-12);
  }
}

} // namespace
} // namespace spricka::test_space_limits
