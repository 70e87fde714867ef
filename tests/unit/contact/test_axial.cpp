// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/pairing.hpp"
#include "contact/recovery.hpp"
#include "model/model.hpp"
#include "two_blocks.hpp"

#include <cmath>

#include <gtest/gtest.h>

// Rows and pressures about an axis: the upper disc stands on the lower one, x is the radius.
namespace spricka::test_axial {
namespace {

using base::ElementType;
using base::Vec3;
using test::TwoBlocks;

constexpr double pi = std::numbers::pi;

struct Case {
  ElementType type;
  model::PairingMethod pairing;
  int upper;
};

class Axial : public testing::TestWithParam<Case> {
protected:
  [[nodiscard]] static contact::PairConstraints rows(double from, const model::Model& model) {
    contact::PairConstraints pair =
        contact::build_pair_constraints(model, model.mesh, model.contacts[0]);
    EXPECT_TRUE(pair.found && pair.trouble.empty()) << from << pair.trouble;
    return pair;
  }
  [[nodiscard]] static model::Model discs(double from) {
    TwoBlocks spec;
    spec.type = GetParam().type;
    spec.upper = GetParam().upper;
    spec.from = from;
    model::Model model = test::two_blocks(spec);
    model.contacts[0].pairing = GetParam().pairing;
    return model;
  }
};

// The areas are those of discs and rings; a row opens by its area when the upper disc rises by one.
TEST_P(Axial, AreasAreThoseOfTheWholeCircumference) {
  for (const double from : {0.0, GetParam().pairing == model::PairingMethod::node ? 0.0 : 0.7}) {
    const model::Model model = discs(from);
    const contact::PairConstraints pair = rows(from, model);
    double area = 0.0;
    double thrust = 0.0; // of a unit pressure, on the upper disc
    for (const contact::ConstraintRow& row : pair.normal) {
      EXPECT_GT(row.area, 0.0);
      area += row.area;
      double balance = 0.0;
      for (const contact::RowEntry& entry : row.entries) {
        EXPECT_LT(std::abs(entry.weight.x()), 1e-15);
        balance += entry.weight.y();
        const bool upper = model.mesh.node_net[entry.node.index()] == base::NetId(std::size_t{1});
        thrust += upper ? entry.weight.y() : 0.0;
      }
      EXPECT_LT(std::abs(balance), 1e-13 * row.area);
    }
    const double exact = pi * (4.0 - from * from);
    EXPECT_NEAR(area, exact, 1e-12 * exact);
    EXPECT_NEAR(thrust, exact, 1e-12 * exact);
  }
}

// Integral of the radius over the disc: rows are exact for displacements that vary along it.
TEST_P(Axial, FirstMomentIsExact) {
  if (GetParam().pairing == model::PairingMethod::node) {
    return; // lumped rows are not
  }
  const model::Model model = discs(0.0);
  double sum = 0.0;
  for (const contact::ConstraintRow& row : rows(0.0, model).normal) {
    for (const contact::RowEntry& entry : row.entries) {
      if (model.mesh.node_net[entry.node.index()] == base::NetId(std::size_t{1})) {
        sum += entry.weight.y() * model.mesh.x[entry.node.index()].x();
      }
    }
  }
  EXPECT_NEAR(sum, 2.0 * pi * 8.0 / 3.0, 1e-12 * sum);
}

TEST_P(Axial, UniformPressureComesBackUpToTheAxis) {
  const model::Model model = discs(0.0);
  const contact::PairConstraints pair = rows(0.0, model);
  const auto n = static_cast<Eigen::Index>(pair.normal.size());
  const contact::PairPressure p =
      contact::recover_pressure(pair, base::Vector::Constant(n, 7.0), base::Vector::Zero(n),
                                std::vector<bool>(pair.normal.size(), true));
  for (const contact::NodePressure& node : p.nodes) {
    EXPECT_NEAR(node.p_lumped, 7.0, 1e-11);
    EXPECT_NEAR(node.p_consistent, 7.0, 1e-11);
    EXPECT_TRUE(node.closed);
  }
  EXPECT_NEAR(p.mean_pressure, 7.0, 1e-12);
  EXPECT_NEAR(p.force_on_slave.y(), 7.0 * pi * 4.0, 1e-11);
  EXPECT_DOUBLE_EQ(p.arc_from, 0.0);
  EXPECT_NEAR(p.arc_to, 2.0, 1e-14);
}

INSTANTIATE_TEST_SUITE_P(
    Types, Axial,
    testing::Values(Case{ElementType::quam4, model::PairingMethod::segment, 7},
                    Case{ElementType::quamc8, model::PairingMethod::segment, 3},
                    Case{ElementType::trimc6, model::PairingMethod::segment, 7},
                    Case{ElementType::quam4, model::PairingMethod::node, 5},
                    Case{ElementType::quamc8, model::PairingMethod::node, 5}));

// p = 1 - r^2/4 on ever finer discs: at the axis, where a corner of quadratic edges has no area,
// the pressure is right to the second order as it is elsewhere.
TEST(AxialRecovery, PressureAtTheAxisConverges) {
  double last = 0.0;
  for (const int n : {10, 20, 40}) {
    TwoBlocks spec;
    spec.lower = spec.upper = n;
    const model::Model model = test::two_blocks(spec);
    const contact::PairConstraints pair =
        contact::build_pair_constraints(model, model.mesh, model.contacts[0]);
    base::Vector lambda(static_cast<Eigen::Index>(pair.normal.size()));
    for (std::size_t i = 0; i < pair.normal.size(); ++i) {
      const double r = model.mesh.x[pair.normal[i].node.index()].x();
      lambda[static_cast<Eigen::Index>(i)] = 1.0 - 0.25 * r * r;
    }
    const contact::PairPressure p =
        contact::recover_pressure(pair, lambda, base::Vector::Zero(lambda.size()),
                                  std::vector<bool>(pair.normal.size(), true));
    double worst = 0.0;
    for (const contact::NodePressure& node : p.nodes) {
      if (node.x.x() < 1.0) {
        worst = std::max(worst, std::abs(node.p_lumped - (1.0 - 0.25 * node.x.squaredNorm() +
                                                          0.25 * node.x.y() * node.x.y())));
      }
    }
    const double h = 2.0 / n;
    EXPECT_LT(worst, 0.2 * h * h);
    if (last > 0.0) {
      EXPECT_LT(worst, last / 3.0);
    }
    last = worst;
  }
}

} // namespace
} // namespace spricka::test_axial
