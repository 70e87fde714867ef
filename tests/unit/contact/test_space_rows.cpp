// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/pairing.hpp"
#include "contact/recovery.hpp"
#include "model/model.hpp"
#include "stacked_solids.hpp"

#include <cmath>
#include <functional>
#include <map>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

namespace spricka::test_space_rows {
namespace {

using base::ElementType;
using base::Vec3;

// What all rows together open if every node moves so.
double opening(const contact::ConstraintRow& row, const model::Mesh& mesh,
               const std::function<Vec3(const Vec3&, base::NetId)>& u) {
  double g = 0.0;
  for (const contact::RowEntry& entry : row.entries) {
    g += entry.weight.dot(u(mesh.x[entry.node.index()], mesh.node_net[entry.node.index()]));
  }
  return g;
}

const base::NetId up{std::size_t{0}};

using PairingMethod = std::tuple<ElementType, ElementType, bool, bool>;

class SpaceRows : public testing::TestWithParam<PairingMethod> {
protected:
  void SetUp() override {
    const auto [upper, lower, upper_is_slave, soft_upper] = GetParam();
    test::StackSpec spec;
    spec.upper_type = upper;
    spec.lower_type = lower;
    spec.upper_is_slave = upper_is_slave;
    spec.more_on_upper = soft_upper;
    model = test::stacked_solids(spec);
    pair = contact::build_pair_constraints(model, model.mesh, model.contacts[0]);
  }
  model::Model model;
  contact::PairConstraints pair;
};

TEST_P(SpaceRows, CoverTheFootAndNoMore) {
  ASSERT_TRUE(pair.trouble.empty()) << pair.trouble;
  double area = 0.0;
  for (const contact::ConstraintRow& row : pair.normal) {
    EXPECT_GT(row.area, 0.0);
    area += row.area;
  }
  EXPECT_NEAR(area, 36.0, 1e-10);
}

TEST_P(SpaceRows, ForcesOfARowBalanceAndHaveNoMoment) {
  for (const contact::ConstraintRow& row : pair.normal) {
    Vec3 force = Vec3::Zero();
    Vec3 moment = Vec3::Zero();
    for (const contact::RowEntry& entry : row.entries) {
      force += entry.weight;
      moment += model.mesh.x[entry.node.index()].cross(entry.weight);
    }
    EXPECT_LT(force.norm(), 1e-12 * row.area);
    EXPECT_LT(moment.norm(), 1e-11 * row.area);
  }
}

// Duality makes the weights of a linear field those at places whose mean is the row's.
TEST_P(SpaceRows, AUnitOfApproachClosesEachRowByItsArea) {
  for (const contact::ConstraintRow& row : pair.normal) {
    const double g = opening(row, model.mesh, [](const Vec3&, base::NetId net) {
      return Vec3(0.0, 0.0, net == up ? 1.0 : 0.0);
    });
    EXPECT_NEAR(g, row.area, 1e-11 * row.area);
  }
}

TEST_P(SpaceRows, SlidingOpensNothing) {
  for (const contact::ConstraintRow& row : pair.normal) {
    const double g = opening(row, model.mesh, [](const Vec3& x, base::NetId net) {
      return net == up ? Vec3(0.3 - x.y(), 0.2 + x.x(), 0.0) : Vec3::Zero();
    });
    EXPECT_LT(std::abs(g), 1e-11 * row.area);
  }
}

// A unit of pressure everywhere is, on each of the sides, the consistent load of a unit of pressure
// on what touches: its moments about x and y are those of the foot.
TEST_P(SpaceRows, AUnitOfPressureIsTheLoadOfTheFoot) {
  Vec3 force = Vec3::Zero();
  double second = 0.0; // sum of force times x^2 + y^2, which functions of second order know
  for (const contact::ConstraintRow& row : pair.normal) {
    for (const contact::RowEntry& entry : row.entries) {
      if (model.mesh.node_net[entry.node.index()] == up) {
        const Vec3& x = model.mesh.x[entry.node.index()];
        force += entry.weight;
        second += entry.weight.z() * x.head<2>().squaredNorm();
      }
    }
  }
  EXPECT_LT((force - Vec3(0.0, 0.0, 36.0)).norm(), 1e-10);
  const ElementType type = std::get<0>(GetParam());
  if (base::element_info(type).quadratic) {
    EXPECT_NEAR(second, 216.0, 1e-9); // a b (a^2 + b^2) / 12
  }
}

INSTANTIATE_TEST_SUITE_P(Types, SpaceRows,
                         testing::Combine(testing::Values(ElementType::tet4, ElementType::tet10,
                                                          ElementType::pentac15, ElementType::hexe8,
                                                          ElementType::hexec20,
                                                          ElementType::hexec27),
                                          testing::Values(ElementType::tet10, ElementType::hexec20),
                                          testing::Bool(), testing::Bool()));

TEST(SpaceSide, TheCoarserSideCarriesTheMultipliers) {
  test::StackSpec spec;
  spec.upper_cells = 3; // 2 wide against 10/9
  spec.lower_cells = 9;
  const model::Model model = test::stacked_solids(spec);
  const contact::PairConstraints pair =
      contact::build_pair_constraints(model, model.mesh, model.contacts[0]);
  EXPECT_FALSE(pair.swapped);
  EXPECT_EQ(pair.choice, "slave side: coarser where they meet");
  spec.upper_is_slave = false;
  const model::Model other = test::stacked_solids(spec);
  EXPECT_TRUE(contact::build_pair_constraints(other, other.mesh, other.contacts[0]).swapped);
}

// A coarse side of which the other meets few faces would have few functions there.
TEST(SpaceSide, AFootOnFewCoarseFacesHasThemItself) {
  test::StackSpec spec;
  spec.lower_cells = 2;
  spec.upper_cells = 4;
  const model::Model model = test::stacked_solids(spec);
  const contact::PairConstraints pair =
      contact::build_pair_constraints(model, model.mesh, model.contacts[0]);
  EXPECT_FALSE(pair.swapped);
  EXPECT_EQ(pair.choice, "slave side: few faces of the coarser one are met");
}

// Sizes count where the surfaces meet, not those of the whole set.
TEST(SpaceSide, FacesFarFromThePartnerDoNotCount) {
  test::StackSpec spec;
  spec.upper_cells = 6; // 1 wide, on a block that is fine below it and coarse beside it
  spec.lower_cells = 20;
  spec.turn = 0.0;
  spec.lower_size = 10.0;
  model::Model model = test::stacked_solids(spec);
  for (std::size_t n = 0; n < model.mesh.node_count(); ++n) {
    base::Vec3& x = model.mesh.x[n];
    for (Eigen::Index c = 0; c < 2 && model.mesh.node_net[n] != up; ++c) {
      x[c] *= std::abs(x[c]) > 3.0 ? 1.0 + 4.0 * (std::abs(x[c]) - 3.0) : 1.0;
    }
  }
  const contact::PairConstraints pair =
      contact::build_pair_constraints(model, model.mesh, model.contacts[0]);
  EXPECT_FALSE(pair.swapped) << pair.choice; // 1 against 0.5
}

TEST(SpaceOverhang, WeakFunctionsJoinTheirNeighbours) {
  test::StackSpec spec; // the larger block carries the multipliers and hangs over all round
  spec.upper_cells = 8;
  spec.lower_cells = 5;
  const model::Model model = test::stacked_solids(spec);
  const contact::PairConstraints pair =
      contact::build_pair_constraints(model, model.mesh, model.contacts[0]);
  EXPECT_TRUE(pair.swapped);
  EXPECT_GT(pair.merged, 0);
  double area = 0.0;
  std::map<int, double> by_row;
  for (const contact::MultiplierFunction& function : pair.functions) {
    area += function.area;
    if (function.row >= 0) {
      by_row[function.row] += function.area;
    } else {
      EXPECT_EQ(function.area, 0.0);
    }
  }
  EXPECT_NEAR(area, 36.0, 1e-10);
  for (const auto& [row, sum] : by_row) {
    EXPECT_NEAR(sum, pair.normal[static_cast<std::size_t>(row)].area, 1e-12);
  }
}

TEST(SpaceGap, MeasuredAlongTheNormal) {
  test::StackSpec spec;
  model::Model model = test::stacked_solids(spec);
  model.contacts[0].gap.reset();
  for (std::size_t n = 0; n < model.mesh.node_count(); ++n) {
    if (model.mesh.node_net[n] == up) { // lifted, and tilted about y
      model.mesh.x[n].z() += 0.05 + 0.01 * model.mesh.x[n].x();
    }
  }
  const contact::PairConstraints pair =
      contact::build_pair_constraints(model, model.mesh, model.contacts[0]);
  double volume = 0.0;
  double round = 0.0;
  for (const contact::ConstraintRow& row : pair.normal) {
    volume += row.gap;
    round += std::abs(row.gap - row.round_gap);
  }
  // Over the tilted foot, along its normal: both are longer by sqrt(1 + 0.01^2).
  EXPECT_NEAR(volume, 36.0 * 0.05 * (1.0 + 1e-4), 1e-10);
  EXPECT_LT(round, 1e-10); // planes are what they are
}

TEST(SpacePressure, OfEqualMultipliersIsTheSameEverywhere) {
  const model::Model model = test::stacked_solids({});
  const contact::PairConstraints pair =
      contact::build_pair_constraints(model, model.mesh, model.contacts[0]);
  const auto n = static_cast<Eigen::Index>(pair.normal.size());
  const contact::PairPressure p =
      contact::recover_pressure(pair, base::Vector::Constant(n, 3.0), base::Vector::Zero(n),
                                std::vector<bool>(pair.normal.size(), true));
  for (const contact::NodePressure& node : p.nodes) {
    const double expected = node.row >= 0 ? 3.0 : 0.0;
    EXPECT_NEAR(node.p_lumped, expected, 1e-13);
    EXPECT_NEAR(node.p_consistent, expected, 1e-13);
  }
  EXPECT_NEAR(p.area, 36.0, 1e-10);
  EXPECT_NEAR(p.mean_pressure, 3.0, 1e-13);
  EXPECT_LT((p.force_on_slave - Vec3(0.0, 0.0, 108.0)).norm(), 1e-9);
}

} // namespace
} // namespace spricka::test_space_rows
