// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/pairing.hpp"
#include "model/model.hpp"
#include "two_rings.hpp"

#include <functional>
#include <numbers>

#include <gtest/gtest.h>

namespace spricka::test_pairing {
namespace {

using base::ElementType;

double opening(const contact::ConstraintRow& row, const model::Mesh& mesh,
               const std::function<base::Vec3(const base::Vec3&, base::NodeId)>& u) {
  double g = 0.0;
  for (const contact::RowEntry& entry : row.entries) {
    g += entry.weight.dot(u(mesh.x[entry.node.index()], entry.node));
  }
  return g;
}

class PairingMethod : public testing::TestWithParam<ElementType> {};

TEST_P(PairingMethod, RowsOfFullCirclesCoverTheWholeSurface) {
  const model::Model model = test::two_rings(16, 21, GetParam());
  const contact::PairConstraints pair =
      contact::build_pair_constraints(model, model.mesh, model.contacts[0]);
  ASSERT_TRUE(pair.found);
  EXPECT_TRUE(pair.trouble.empty()) << pair.trouble;
  double area = 0.0;
  for (const contact::ConstraintRow& row : pair.normal) {
    EXPECT_GT(row.area, 0.0);
    area += row.area;
  }
  double length = 0.0; // of the discrete surface that carries the rows
  for (const contact::Edge& edge : pair.contact.plane.edges) {
    length += edge.length;
  }
  EXPECT_NEAR(area, 5.0 * length, 1e-6 * area);
}

TEST_P(PairingMethod, ForcesOfARowBalanceAndHaveNoMoment) {
  const model::Model model = test::two_rings(16, 21, GetParam());
  const contact::PairConstraints pair =
      contact::build_pair_constraints(model, model.mesh, model.contacts[0]);
  for (const contact::ConstraintRow& row : pair.normal) {
    base::Vec3 sum = base::Vec3::Zero();
    double moment = 0.0;
    for (const contact::RowEntry& entry : row.entries) {
      const base::Vec3& x = model.mesh.x[entry.node.index()];
      sum += entry.weight;
      moment += x.x() * entry.weight.y() - x.y() * entry.weight.x();
    }
    EXPECT_LT(sum.norm(), 1e-13 * row.area);
    EXPECT_LT(std::abs(moment), 1e-12 * row.area);
  }
}

TEST_P(PairingMethod, RotationOfOneRingOpensNothing) {
  const model::Model model = test::two_rings(16, 21, GetParam());
  const contact::PairConstraints pair =
      contact::build_pair_constraints(model, model.mesh, model.contacts[0]);
  for (const contact::ConstraintRow& row : pair.normal) {
    const double g = opening(row, model.mesh, [&](const base::Vec3& x, base::NodeId n) {
      const bool inner = model.mesh.node_net[n.index()] == base::NetId(std::size_t{0});
      return inner ? base::Vec3(-x.y(), x.x(), 0.0) : base::Vec3::Zero();
    });
    EXPECT_LT(std::abs(g), 1e-13 * row.area);
  }
}

INSTANTIATE_TEST_SUITE_P(Types, PairingMethod,
                         testing::Values(ElementType::quam4, ElementType::quamc8,
                                         ElementType::trimc6));

TEST(PairingMethod, DeclaredGapIsUsedExactly) {
  model::Model model = test::two_rings(12, 15, ElementType::quamc8);
  model.contacts[0].gap = -0.01;
  const contact::PairConstraints pair =
      contact::build_pair_constraints(model, model.mesh, model.contacts[0]);
  for (const contact::ConstraintRow& row : pair.normal) {
    EXPECT_DOUBLE_EQ(row.gap, -0.01 * row.area);
  }
}

TEST(PairingMethod, SofterSideCarriesTheMultipliersWhenSizesAreAlike) {
  EXPECT_TRUE(
      contact::build_pair_constraints(test::two_rings(16, 17, ElementType::quamc8, 0.1),
                                      test::two_rings(16, 17, ElementType::quamc8, 0.1).mesh,
                                      test::two_rings(16, 17, ElementType::quamc8, 0.1).contacts[0])
          .swapped);
  const model::Model stiff = test::two_rings(16, 17, ElementType::quamc8, 10.0);
  EXPECT_FALSE(contact::build_pair_constraints(stiff, stiff.mesh, stiff.contacts[0]).swapped);
}

TEST(PairingMethod, CoarserSideCarriesTheMultipliers) {
  const model::Model model = test::two_rings(40, 12, ElementType::quamc8, 10.0);
  EXPECT_TRUE(contact::build_pair_constraints(model, model.mesh, model.contacts[0]).swapped);
}

TEST(PairingMethod, NodePairsThatDoNotMatchAreRefused) {
  model::Model model = test::two_rings(16, 21, ElementType::quamc8);
  model.contacts[0].pairing = model::PairingMethod::node;
  const contact::PairConstraints pair =
      contact::build_pair_constraints(model, model.mesh, model.contacts[0]);
  EXPECT_TRUE(!pair.trouble.empty() || !pair.found);
}

TEST(PairingMethod, SurfacesThatLookAwayAreNotFound) {
  model::Model model = test::two_rings(16, 21, ElementType::quamc8);
  for (std::size_t i = 0; i < model.mesh.face_sets.size(); ++i) {
    if (model.mesh.face_sets[i].name == "OUT.OUTER") {
      model.contacts[0].master = base::FaceSetId(i);
    }
  }
  const contact::PairConstraints pair =
      contact::build_pair_constraints(model, model.mesh, model.contacts[0]);
  EXPECT_FALSE(pair.found);
}

// With friction there is a slip row behind each normal row, that of a bonded pair; the turn of one
// ring slips it by area times angle times radius.
TEST(PairingMethod, FrictionHasTheSlipRowsOfABondedPair) {
  model::Model model = test::two_rings(16, 21, ElementType::quamc8);
  model::Contact contact = model.contacts[0];
  EXPECT_TRUE(contact::build_pair_constraints(model, model.mesh, contact).tangent.empty());
  contact.mu = 0.3;
  const contact::PairConstraints rubs = contact::build_pair_constraints(model, model.mesh, contact);
  contact.mu = 0.0;
  contact.type = model::ContactType::bonded;
  const contact::PairConstraints bonded =
      contact::build_pair_constraints(model, model.mesh, contact);
  ASSERT_EQ(rubs.tangent.size(), rubs.normal.size());
  ASSERT_EQ(rubs.tangent.size(), bonded.tangent.size());
  for (std::size_t i = 0; i < rubs.tangent.size(); ++i) {
    const contact::ConstraintRow& row = rubs.tangent[i];
    EXPECT_TRUE(row.tangential);
    EXPECT_EQ(row.node, rubs.normal[i].node);
    EXPECT_EQ(row.area, rubs.normal[i].area);
    const auto turn = [&](const base::Vec3& x, base::NodeId n) -> base::Vec3 {
      const bool inner = model.mesh.node_net[n.index()].index() == 0;
      return inner ? base::Vec3(-x.y(), x.x(), 0.0) : base::Vec3::Zero();
    };
    // whichever side carries the rows, its tangent is its normal turned to the left
    EXPECT_NEAR(std::abs(opening(row, model.mesh, turn)), 2.0 * row.area, 1e-3 * row.area);
    for (std::size_t k = 0; k < row.entries.size(); ++k) {
      EXPECT_EQ((row.entries[k].weight - bonded.tangent[i].entries[k].weight).norm(), 0.0);
    }
  }
}

} // namespace
} // namespace spricka::test_pairing
