// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/pairing.hpp"
#include "contact/recovery.hpp"
#include "contact/smooth.hpp"
#include "model/model.hpp"
#include "two_rings.hpp"

#include <numbers>

#include <gtest/gtest.h>

namespace spricka::test_recovery {
namespace {

TEST(Recovery, UniformPressureComesBackFromBothMasses) {
  const model::Model model = test::two_rings(24, 31, base::ElementType::quamc8);
  const contact::PairConstraints pair =
      contact::build_pair_constraints(model, model.mesh, model.contacts[0]);
  const auto n = static_cast<Eigen::Index>(pair.normal.size());
  const contact::PairPressure p =
      contact::recover_pressure(pair, base::Vector::Constant(n, 7.0), base::Vector::Zero(n),
                                std::vector<bool>(pair.normal.size(), true));
  ASSERT_EQ(p.nodes.size(), pair.normal.size());
  for (const contact::NodePressure& node : p.nodes) {
    EXPECT_NEAR(node.p_lumped, 7.0, 1e-5); // normals between nodes turn with the arc
    EXPECT_NEAR(node.p_consistent, 7.0, 1e-12);
    EXPECT_EQ(node.crack_face, 0);
  }
  EXPECT_NEAR(p.mean_pressure, 7.0, 1e-12);
  EXPECT_LT(p.force_on_slave.norm(), 1e-10);
  EXPECT_DOUBLE_EQ(p.arc_from, -std::numbers::pi);
  EXPECT_DOUBLE_EQ(p.arc_to, std::numbers::pi);
}

// Node pairs: a uniform pressure on quadratic edges that span 2 t of the circle puts r sin t times
// 4/3 on middles and 2/3 (2 - cos t) on corners; both masses undo that.
TEST(Recovery, NodePairsGiveUniformPressureFromConsistentForces) {
  model::Model model = test::two_rings(24, 24, base::ElementType::quamc8);
  const double turn = -0.3; // the outer ring turned back, so that nodes match
  for (std::size_t n = 0; n < model.mesh.node_count(); ++n) {
    if (model.mesh.node_net[n] == base::NetId(std::size_t{1})) {
      const base::Vec3 x = model.mesh.x[n];
      model.mesh.x[n] = {std::cos(turn) * x.x() - std::sin(turn) * x.y(),
                         std::sin(turn) * x.x() + std::cos(turn) * x.y(), 0.0};
    }
  }
  model.contacts[0].pairing = model::PairingMethod::node;
  const contact::PairConstraints pair =
      contact::build_pair_constraints(model, model.mesh, model.contacts[0]);
  ASSERT_TRUE(pair.found && pair.trouble.empty()) << pair.trouble;
  const auto n = static_cast<Eigen::Index>(pair.normal.size());
  const double t = std::numbers::pi / 24.0;
  base::Vector lambda(n);
  for (Eigen::Index i = 0; i < n; ++i) {
    const double area = pair.normal[static_cast<std::size_t>(i)].area; // 20/3 or 40/3 t
    const double share = area < 10.0 * t ? 2.0 * (2.0 - std::cos(t)) : 4.0;
    lambda[i] = 7.0 * 5.0 * 2.0 * std::sin(t) * share / 3.0 / area;
  }
  const contact::PairPressure p = contact::recover_pressure(
      pair, lambda, base::Vector::Zero(n), std::vector<bool>(pair.normal.size(), true));
  for (const contact::NodePressure& node : p.nodes) {
    EXPECT_NEAR(node.p_lumped, 7.0, 7.0 * t * t * t * t);
    EXPECT_NEAR(node.p_consistent, 7.0, 7.0 * t * t * t * t);
  }
}

// A node at the rim of the paired part has the pressure of its row, not its force over an area that
// is only half in contact.
TEST(Recovery, RimOfThePairedPartKeepsItsPressure) {
  model::Model model = test::two_rings(24, 31, base::ElementType::quamc8);
  std::vector<model::Face>& outer = model.mesh.face_sets[model.contacts[0].master.index()].faces;
  outer.erase(outer.begin(), outer.begin() + 12);
  const contact::PairConstraints pair =
      contact::build_pair_constraints(model, model.mesh, model.contacts[0]);
  ASSERT_FALSE(pair.swapped);
  const auto n = static_cast<Eigen::Index>(pair.normal.size());
  const contact::PairPressure p =
      contact::recover_pressure(pair, base::Vector::Constant(n, 7.0), base::Vector::Zero(n),
                                std::vector<bool>(pair.normal.size(), true));
  int paired = 0;
  for (const contact::NodePressure& node : p.nodes) {
    EXPECT_TRUE(node.p_lumped == 0.0 || std::abs(node.p_lumped - 7.0) < 1e-5) << node.p_lumped;
    paired += node.p_lumped > 0.0 ? 1 : 0;
  }
  EXPECT_EQ(paired, n);
}

/// Mean of sqrt(1 - (t/c)^2) over the hat of half width d about theta: what a row's multiplier is.
double hertz_mean(double theta, double c, double d) {
  constexpr int points = 400;
  double sum = 0.0;
  for (int i = 0; i < points; ++i) {
    const double x = (2.0 * i + 1.0) / points - 1.0;
    const double t = (theta + x * d) / c;
    sum += (1.0 - std::abs(x)) * (std::abs(t) < 1.0 ? std::sqrt(1.0 - t * t) : 0.0);
  }
  return 2.0 * sum / points;
}

// p = p0 sqrt(1 - (theta / c)^2) over |theta| < c: its force and moment find c between the nodes.
TEST(Recovery, ArcEndsFollowTheSquareRootLaw) {
  const model::Model model = test::two_rings(72, 72, base::ElementType::quamc8);
  const contact::PairConstraints pair =
      contact::build_pair_constraints(model, model.mesh, model.contacts[0]);
  const double c = 1.234;
  base::Vector lambda(static_cast<Eigen::Index>(pair.normal.size()));
  std::vector<bool> closed;
  for (const contact::ConstraintRow& row : pair.normal) {
    const base::Vec3& x = model.mesh.x[row.node.index()];
    const double theta = std::atan2(x.y(), x.x());
    closed.push_back(std::abs(theta) < c);
    lambda[static_cast<Eigen::Index>(closed.size()) - 1] =
        closed.back() ? hertz_mean(theta, c, std::numbers::pi / 72.0) : 0.0;
  }
  const contact::PairPressure p =
      contact::recover_pressure(pair, lambda, base::Vector::Zero(lambda.size()), closed);
  const double spacing = 2.0 * std::numbers::pi / 144.0;
  EXPECT_NEAR(p.arc_to, c, 0.3 * spacing);
  EXPECT_NEAR(p.arc_from, -c, 0.3 * spacing);
}

// Half a ring with the load on its symmetry line: the surface's end is no end of contact to be
// found between nodes, and the open end on the other side does not touch this one.
TEST(Recovery, ArcEndsWhereTheSurfaceEnds) {
  model::Model model = test::two_rings(36, 36, base::ElementType::quamc8);
  std::vector<model::Face>& inner = model.mesh.face_sets[model.contacts[0].slave.index()].faces;
  inner.erase(inner.begin() + 18, inner.end()); // 0 to 180 degrees stay
  for (const bool flipped : {false, true}) {
    const contact::PairConstraints pair =
        contact::build_pair_constraints(model, model.mesh, model.contacts[0]);
    ASSERT_FALSE(pair.swapped);
    const double c = 1.234;
    base::Vector lambda = base::Vector::Zero(static_cast<Eigen::Index>(pair.normal.size()));
    std::vector<bool> closed;
    for (const contact::ConstraintRow& row : pair.normal) {
      const base::Vec3& x = model.mesh.x[row.node.index()];
      double theta = std::atan2(x.y(), x.x());
      theta = flipped ? std::numbers::pi - theta : theta;
      closed.push_back(theta < c);
      if (closed.back()) {
        lambda[static_cast<Eigen::Index>(closed.size()) - 1] =
            hertz_mean(theta, c, std::numbers::pi / 36.0);
      }
    }
    const contact::PairPressure p =
        contact::recover_pressure(pair, lambda, base::Vector::Zero(lambda.size()), closed);
    const double spacing = 2.0 * std::numbers::pi / 72.0;
    EXPECT_NEAR(flipped ? std::numbers::pi - p.arc_to : p.arc_from, 0.0, 1e-12);
    EXPECT_NEAR(flipped ? std::numbers::pi - p.arc_from : p.arc_to, c, 0.3 * spacing);
  }
}

// A pair that is open all along has no arc, whatever gap is left.
TEST(Recovery, OpenPairHasNoArc) {
  const model::Model model = test::two_rings(24, 31, base::ElementType::quamc8);
  const contact::PairConstraints pair =
      contact::build_pair_constraints(model, model.mesh, model.contacts[0]);
  const auto n = static_cast<Eigen::Index>(pair.normal.size());
  const contact::PairPressure p =
      contact::recover_pressure(pair, base::Vector::Zero(n), base::Vector::Constant(n, 1.0),
                                std::vector<bool>(pair.normal.size(), false));
  EXPECT_EQ(p.arc_from, 0.0);
  EXPECT_EQ(p.arc_to, 0.0);
  EXPECT_EQ(p.closed, 0);
}

// Waves between corners and middles do next to no work on triangles: they are not reported. What is
// linear along the surface stays, on edges of any lengths.
TEST(Recovery, WavesBetweenCornersAndMiddlesAreLeftOut) {
  contact::ContactSurface surface;
  contact::Numbering number;
  std::vector<double> place;
  const auto node = [&](double s) {
    number.try_emplace(base::NodeId(place.size()), static_cast<Eigen::Index>(place.size()));
    place.push_back(s);
    return base::NodeId(place.size() - 1);
  };
  double s = 0.0;
  base::NodeId last = node(s);
  for (const double length : {1.0, 0.4, 0.7, 2.0, 0.3}) {
    contact::Edge edge;
    edge.count = 3;
    edge.length = length;
    edge.nodes = {last, base::NodeId(), base::NodeId()};
    edge.nodes[2] = node(s + 0.5 * length);
    edge.nodes[1] = node(s + length);
    s += length;
    last = edge.nodes[1];
    surface.plane.edges.push_back(edge);
  }
  surface.plane.chains.push_back({0, surface.plane.edges.size(), false});
  base::Vector lambda(static_cast<Eigen::Index>(place.size()));
  for (std::size_t i = 0; i < place.size(); ++i) {
    lambda[static_cast<Eigen::Index>(i)] = 3.0 - 0.5 * place[i];
  }
  base::Vector plain = base::Vector::Zero(lambda.size());
  contact::filter_alternating_pressure(surface, number, std::vector<bool>(5, true), lambda, plain);
  EXPECT_LT((plain - lambda).cwiseAbs().maxCoeff(), 1e-14);
  base::Vector wave = lambda;
  for (Eigen::Index i = 0; i < wave.size(); ++i) {
    wave[i] += i % 2 == 0 ? 0.1 : -0.1;
  }
  base::Vector without = base::Vector::Zero(lambda.size());
  contact::filter_alternating_pressure(surface, number, std::vector<bool>(5, true), wave, without);
  EXPECT_LT((without - plain).cwiseAbs().maxCoeff(), 1e-14);
  base::Vector open = base::Vector::Constant(lambda.size(), -1.0); // edge 2 is open
  contact::filter_alternating_pressure(surface, number, {true, true, false, true, true}, wave,
                                       open);
  for (const Eigen::Index i : {4, 5, 6}) {
    EXPECT_EQ(open[i], -1.0);
  }
}

} // namespace
} // namespace spricka::test_recovery
