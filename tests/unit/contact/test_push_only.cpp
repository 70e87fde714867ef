// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/pairing.hpp"
#include "contact/push_only.hpp"
#include "contact/recovery.hpp"
#include "contact/surface_boundary.hpp"
#include "mesh/boundary.hpp"
#include "model/model.hpp"
#include "two_blocks.hpp"
#include "two_rings.hpp"

#include <cmath>
#include <numbers>
#include <random>

#include <gtest/gtest.h>

namespace spricka::test_push_only {
namespace {

using base::Vector;

std::vector<Eigen::Index> running(std::size_t n) {
  std::vector<Eigen::Index> order;
  for (std::size_t i = 0; i < n; ++i) {
    order.push_back(static_cast<Eigen::Index>(i));
  }
  return order;
}

// Whatever pulls: the force and the shear of the whole stay, and so does a ratio q / p of all
// nodes.
TEST(PushOnly, ForceAndShearStayAndNothingPulls) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> value(-0.4, 1.0);
  for (const bool round : {false, true}) {
    const model::Model model = round ? test::two_rings(24, 24, base::ElementType::quamc8)
                                     : test::two_blocks({.lower = 12, .upper = 12});
    const contact::ContactSurface surface =
        contact::make_contact_surface(model, model.mesh, model.contacts[0].slave);
    const std::size_t n = contact::node_ranges_of_chains(surface).front().count;
    ASSERT_EQ(contact::node_ranges_of_chains(surface).front().closed, round);
    for (int k = 0; k < 200; ++k) {
      Vector p(static_cast<Eigen::Index>(n));
      Vector area(p.size());
      for (Eigen::Index i = 0; i < p.size(); ++i) {
        p[i] = value(random);
        area[i] = 0.3 + std::abs(value(random));
      }
      Vector q = 0.3 * p;
      const double force = area.dot(p);
      contact::redistribute_tension(surface, running(n), area, {p, q});
      EXPECT_GE(p.minCoeff(), 0.0);
      ASSERT_GT(force, 0.0);
      EXPECT_NEAR(area.dot(p), force, 1e-12 * force);
      EXPECT_NEAR((q - 0.3 * p).cwiseAbs().maxCoeff(), 0.0, 1e-12);
    }
  }
}

// A lone pull beside a push: the nearest nodes bear it, those far away are left alone.
TEST(PushOnly, TheNearestNodesBearIt) {
  const model::Model model = test::two_blocks({.lower = 4, .upper = 4});
  const contact::ContactSurface surface =
      contact::make_contact_surface(model, model.mesh, model.contacts[0].slave);
  Vector p = Vector::Constant(9, 2.0);
  Vector q;
  p[3] = -1.0;
  contact::redistribute_tension(surface, running(9), Vector::Ones(9), {p, q});
  EXPECT_EQ(p[3], 0.0);
  EXPECT_DOUBLE_EQ(p[2], 1.5);
  EXPECT_DOUBLE_EQ(p[4], 1.5);
  EXPECT_EQ(p[1], 2.0);
  EXPECT_EQ(p[5], 2.0);
}

// Mean of sqrt(1 - (x/a)^2) over the hat of half width d about x: what a row's multiplier is.
double hertz_mean(double x, double a, double d) {
  constexpr int points = 200;
  double sum = 0.0;
  for (int i = 0; i < points; ++i) {
    const double r = (2.0 * i + 1.0) / points - 1.0;
    const double t = (x + r * d) / a;
    sum += (1.0 - std::abs(r)) * (std::abs(t) < 1.0 ? std::sqrt(1.0 - t * t) : 0.0);
  }
  return 2.0 * sum / points;
}

// Hertz's pressure over |x - 1| < a on a flat surface: the mean over the part in contact is pi/4 of
// the largest, wherever its ends lie between the nodes.
TEST(PushOnly, MeanOfHertzIsThatOfThePartInContact) {
  for (const base::ElementType type : {base::ElementType::quamc8, base::ElementType::quam4}) {
    for (const bool nodes : {false, true}) {
      model::Model model = test::two_blocks(
          {.type = type, .state = model::StressState::plane_strain, .lower = 40, .upper = 40});
      model.contacts[0].pairing =
          nodes ? model::PairingMethod::node : model::PairingMethod::segment;
      const contact::PairConstraints pair =
          contact::build_pair_constraints(model, model.mesh, model.contacts[0]);
      const double spacing = type == base::ElementType::quam4 ? 0.05 : 0.025;
      for (double a = 0.5; a < 0.5 + spacing; a += 0.2 * spacing) {
        Vector lambda(static_cast<Eigen::Index>(pair.normal.size()));
        std::vector<bool> closed;
        for (const contact::ConstraintRow& row : pair.normal) {
          const double x = model.mesh.x[row.node.index()].x() - 1.0;
          closed.push_back(std::abs(x) < a);
          lambda[static_cast<Eigen::Index>(closed.size()) - 1] =
              closed.back() ? hertz_mean(x, a, spacing) : 0.0;
        }
        const contact::PairPressure p =
            contact::recover_pressure(pair, lambda, Vector::Zero(lambda.size()), closed);
        EXPECT_NEAR(p.mean_pressure, 0.25 * std::numbers::pi, 0.018) << a << " " << nodes;
      }
    }
  }
}

// A peak of one multiplier at the middle of a quadratic edge would pull at its corners.
TEST(PushOnly, RecoveredPressureOfARandomPairNeverPulls) {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> value(-1.0, 1.0);
  for (const bool nodes : {false, true}) {
    model::Model model = test::two_blocks(
        {.state = model::StressState::plane_stress, .lower = 10, .upper = nodes ? 10 : 7});
    model.contacts[0].pairing = nodes ? model::PairingMethod::node : model::PairingMethod::segment;
    const contact::PairConstraints pair =
        contact::build_pair_constraints(model, model.mesh, model.contacts[0]);
    for (int k = 0; k < 100; ++k) {
      Vector lambda(static_cast<Eigen::Index>(pair.normal.size()));
      std::vector<bool> closed;
      double thrust = 0.0;
      for (Eigen::Index i = 0; i < lambda.size(); ++i) {
        lambda[i] = std::max(0.0, value(random));
        closed.push_back(lambda[i] > 0.0);
        thrust += lambda[i] * pair.normal[static_cast<std::size_t>(i)].area;
      }
      const contact::PairPressure p =
          contact::recover_pressure(pair, lambda, Vector::Zero(lambda.size()), closed);
      EXPECT_NEAR(std::abs(p.force_on_slave.y()), thrust, 1e-12 * thrust);
      for (const contact::NodePressure& node : p.nodes) {
        EXPECT_GE(node.p_lumped, 0.0);
        EXPECT_GE(node.p_consistent, 0.0);
      }
    }
  }
}

// What is glued may pull.
TEST(PushOnly, BondedPairsPull) {
  const model::Model model = test::two_blocks({.state = model::StressState::plane_stress});
  const contact::PairConstraints pair =
      contact::build_pair_constraints(model, model.mesh, model.contacts[0]);
  const auto n = static_cast<Eigen::Index>(pair.normal.size());
  const contact::PairPressure p =
      contact::recover_pressure(pair, Vector::Constant(n, -3.0), Vector::Zero(n),
                                std::vector<bool>(pair.normal.size(), true), true);
  for (const contact::NodePressure& node : p.nodes) {
    EXPECT_NEAR(node.p_lumped, -3.0, 1e-9);
  }
  EXPECT_NEAR(p.mean_pressure, -3.0, 1e-12);
}

// Distances from the outline of a ring: closed form on both circles, the sign by the side.
TEST(PlaneBoundary, TellsInsideFromOutsideByTheNearestPlace) {
  const model::Model model = test::two_rings(48, 48, base::ElementType::quamc8);
  std::vector<model::Face> ring;
  for (const model::Face& face : mesh::boundary_faces(model.mesh)) {
    if (model.mesh.element_net[face.element.index()] == base::NetId(std::size_t{0})) {
      ring.push_back(face);
    }
  }
  const geometry::BodyBoundary outline =
      contact::make_displaced_body_boundary(model, model.mesh, ring, {});
  for (double theta = 0.05; theta < 6.2; theta += 0.37) {
    for (const double r : {0.7, 0.95, 1.05, 1.4, 1.6, 1.95, 2.05, 2.4}) {
      const double wanted = std::max(1.0 - r, r - 2.0); // negative between the circles
      const auto at = outline.signed_distance({r * std::cos(theta), r * std::sin(theta), 0.0}, 1.0);
      ASSERT_TRUE(at);
      EXPECT_NEAR(at->distance, wanted, at->facet + 1e-4) << r;
      EXPECT_LT(at->facet, 1e-3);
    }
  }
  EXPECT_FALSE(outline.signed_distance({2.5, 0.0, 0.0}, 0.4));
}

} // namespace
} // namespace spricka::test_push_only
