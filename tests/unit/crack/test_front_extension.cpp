// SPDX-License-Identifier: GPL-3.0-or-later
// Extensions along fronts in space, and smooth values along them.
#include "crack/front_extension.hpp"
#include "crack/smooth_front.hpp"
#include "tests/unit/crack/front_tube.hpp"

#include <cmath>
#include <map>
#include <numbers>

#include <gtest/gtest.h>

namespace spricka::test_front_extension {
namespace {

using base::Vec3;
using test::Tube;

// Together the points move the whole front by one: on a straight one all nodes of the inner layers
// along m, and none beyond the next.
TEST(FrontExtension, PointsAddUpToAWholeAdvance) {
  const Tube tube(test::straight_front(1.0), {.segments = 4});
  const crack::FrontIntegralDomains fields = tube.fields({1});
  EXPECT_FALSE(fields.closed);
  EXPECT_TRUE(fields.left_out.empty());
  std::map<base::NodeId, Vec3> sum;
  for (const auto& domains : fields.points) {
    ASSERT_EQ(domains.size(), 1U);
    for (const crack::NodeMotion& motion : domains.front().motion) {
      sum.try_emplace(motion.node, Vec3::Zero()).first->second += motion.q * motion.along;
    }
  }
  for (std::size_t n = 0; n < tube.mesh().node_count(); ++n) {
    const double r = tube.mesh().x[n].head<2>().norm();
    const auto at = sum.find(base::NodeId(n));
    const Vec3 q = at == sum.end() ? Vec3(Vec3::Zero()) : at->second;
    const double expected = r < 0.11 ? 1.0 : (r < 0.16 ? 0.5 : 0.0);
    EXPECT_NEAR((q - expected * Vec3::UnitX()).norm(), 0.0, 1e-12) << r;
  }
}

TEST(FrontExtension, HatsAreLinearBetweenPoints) {
  const Tube tube(test::straight_front(1.0), {.segments = 4});
  const crack::FrontIntegralDomains fields = tube.fields({2});
  for (const crack::NodeMotion& motion : fields.points[1].front().motion) {
    const Vec3& x = tube.mesh().x[motion.node.index()];
    if (x.head<2>().norm() < 0.21) {
      EXPECT_NEAR(motion.q, 1.0 - std::abs(x.z() - 0.25) / 0.25, 1e-9);
    }
  }
}

TEST(FrontExtension, ClosedFrontHasNoEnds) {
  const Tube tube(test::penny_front(1.0), {.segments = 8});
  const crack::FrontIntegralDomains fields = tube.fields({1});
  EXPECT_TRUE(fields.closed);
  EXPECT_TRUE(fields.left_out.empty());
  // The first and the last point share the elements between them.
  EXPECT_EQ(fields.points.front().front().elements.size(),
            fields.points.back().front().elements.size());
}

// The tube's own rim is the surface of the body here: what reaches it is left out and says so.
TEST(FrontExtension, LeavesOutWhatWouldMoveTheSurface) {
  const Tube tube(test::penny_front(1.0), {.segments = 8});
  const crack::FrontIntegralDomains fields = tube.fields({2, 3});
  ASSERT_EQ(fields.left_out.size(), 8U);
  EXPECT_EQ(fields.left_out.front().rings, 3);
  EXPECT_NE(fields.left_out.front().why.find("surface"), std::string::npos);
  EXPECT_EQ(fields.points.front().size(), 1U);
}

TEST(FrontExtension, LeavesOutHeldNodesAndOtherMaterials) {
  const Tube tube(test::straight_front(1.0), {.segments = 4});
  crack::IntegrationDomainConstraints limits;
  limits.node.assign(tube.mesh().node_count(), false);
  limits.node[tube.front().points.front().node.index()] = true;
  const crack::FrontIntegralDomains held =
      crack::build_front_domains(tube.cracked, tube.front(), {1}, limits);
  EXPECT_TRUE(held.points[0].empty());
  EXPECT_FALSE(held.points[1].empty());
  crack::IntegrationDomainConstraints zones;
  zones.zone.assign(tube.mesh().element_count(), 0);
  zones.zone.back() = 1;
  const crack::FrontIntegralDomains other =
      crack::build_front_domains(tube.cracked, tube.front(), {2}, zones);
  EXPECT_TRUE(other.points[4].empty());
  EXPECT_FALSE(other.points[0].empty());
}

TEST(FrontExtension, LeavesOutTheCentreOfCurvature) {
  const Tube tube(test::penny_front(0.52), {.segments = 8}); // strains elements up to 0.3 behind
  EXPECT_EQ(tube.fields({2}).points.front().size(), 1U);
  const Tube narrow(test::penny_front(0.45), {.segments = 8});
  EXPECT_TRUE(narrow.fields({2}).points.front().empty());
  EXPECT_EQ(narrow.fields({1}).points.front().size(), 1U);
}

// A tied node moves as its row says, so that the row holds of the moved mesh.
TEST(FrontExtension, TiedNodesFollowTheirMasters) {
  Tube tube(test::straight_front(1.0), {.segments = 4});
  const base::NodeId a = tube.front().points[1].node;
  const base::NodeId b = tube.front().points[2].node;
  const base::NodeId slave = tube.mesh().element_nodes(base::ElementId(std::size_t{0}))[1];
  tube.cracked.ties = {{slave, {a, b}, {0.25, 0.75}, base::CrackId(std::size_t{0})}};
  const crack::FrontIntegralDomains fields = tube.fields({1});
  const auto q = fields.points[2].front().extension_by_node();
  EXPECT_NEAR(q.at(slave), 0.75, 1e-12);
}

crack::FrontStations stations(int count, bool closed) {
  crack::FrontStations at;
  for (int i = 0; i < count; ++i) {
    at.s.push_back(i + 0.2 * std::sin(2.0 * i));
    at.weight.push_back(1.0);
  }
  at.length = count;
  at.closed = closed;
  at.local.assign(static_cast<std::size_t>(count), true);
  return at;
}

TEST(SmoothFront, KeepsCubicsAndCircles) {
  const crack::FrontStations open = stations(13, false);
  base::Matrix values(13, 1);
  for (Eigen::Index i = 0; i < 13; ++i) {
    const double s = open.s[static_cast<std::size_t>(i)];
    values(i, 0) = 1.0 + s - 0.2 * s * s + 0.01 * s * s * s;
  }
  EXPECT_LT((crack::smooth_values_along_front(open, values) - values).norm(), 1e-10);
  const crack::FrontStations round = stations(16, true);
  base::Matrix wave(16, 1);
  for (Eigen::Index i = 0; i < 16; ++i) {
    wave(i, 0) = std::cos(2.0 * std::numbers::pi * round.s[static_cast<std::size_t>(i)] / 16.0);
  }
  EXPECT_LT((crack::smooth_values_along_front(round, wave) - wave).cwiseAbs().maxCoeff(), 3e-3);
  // What alternates from point to point goes.
  base::Matrix rough = wave;
  for (Eigen::Index i = 0; i < 16; ++i) {
    rough(i, 0) += i % 2 == 0 ? 0.1 : -0.1;
  }
  EXPECT_LT((crack::smooth_values_along_front(round, rough) - wave).cwiseAbs().maxCoeff(), 0.05);
}

// Means over hats are undone: of s^2 they are h^2 / 6 too high.
TEST(SmoothFront, GivesBackWhatHatsSmear) {
  crack::FrontStations at = stations(11, false);
  base::Matrix values(11, 1);
  for (std::size_t i = 0; i < 11; ++i) {
    at.s[i] = static_cast<double>(i);
    at.local[i] = i == 0 || i == 10;
    values(static_cast<Eigen::Index>(i), 0) = at.s[i] * at.s[i] + (at.local[i] ? 0.0 : 1.0 / 6.0);
  }
  const base::Matrix smooth = crack::smooth_values_along_front(at, values);
  for (std::size_t i = 0; i < 11; ++i) {
    EXPECT_NEAR(smooth(static_cast<Eigen::Index>(i), 0), at.s[i] * at.s[i], 1e-9);
  }
}

// Of a parabola it is the value itself, whatever the end's own is; an error of one point counts 1.5
// times at most where there are enough of them.
TEST(SmoothFront, GoesOnToTheSurfaceFromInside) {
  const int count = 13;
  crack::FrontStations even = stations(count, false);
  even.weight.front() = 0.0;          // a number of the mesh
  crack::FrontStations graded = even; // as tubes have them
  for (std::size_t i = 0; i < graded.s.size(); ++i) {
    graded.s[i] = std::pow(1.5, static_cast<double>(i)) - 1.0;
  }
  for (const crack::FrontStations& at : {even, graded}) {
    base::Matrix values(count, 1);
    for (Eigen::Index i = 0; i < count; ++i) {
      const double s = at.s[static_cast<std::size_t>(i)];
      values(i, 0) = 2.0 - 0.5 * s + 0.03 * s * s;
    }
    values(0, 0) = 77.0;
    const auto value = crack::extrapolate_front_value(at, values, {at.s[0], 0.0});
    ASSERT_TRUE(value.has_value());
    EXPECT_NEAR((*value)[0], 2.0 - 0.5 * at.s[0] + 0.03 * at.s[0] * at.s[0], 1e-9);
    for (Eigen::Index i = 1; i < count; ++i) {
      base::Matrix wrong = values;
      wrong(i, 0) += 0.1;
      EXPECT_LT(
          std::abs((*crack::extrapolate_front_value(at, wrong, {at.s[0], 0.0}))[0] - (*value)[0]),
          0.15);
    }
  }
}

TEST(SmoothFront, GoesOnFromFewPointsByALine) {
  crack::FrontStations at = stations(4, false);
  at.weight = {0.0, 1.0, 1.0, 0.0};
  base::Matrix values(4, 1);
  values << 77.0, 2.0 - 0.5 * at.s[1], 2.0 - 0.5 * at.s[2], 77.0;
  const auto value = crack::extrapolate_front_value(at, values, {0.0, 0.0});
  ASSERT_TRUE(value.has_value());
  EXPECT_NEAR((*value)[0], 2.0, 1e-12);
  at.weight = {0.0, 1.0, 0.0, 0.0};
  EXPECT_FALSE(crack::extrapolate_front_value(at, values, {0.0, 0.0}).has_value());
}

} // namespace
} // namespace spricka::test_front_extension
