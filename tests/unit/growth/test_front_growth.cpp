// SPDX-License-Identifier: GPL-3.0-or-later
#include "growing_block.hpp"
#include "growth/elliptical_front.hpp"
#include "growth/free_front_shape.hpp"
#include "growth/join_fronts.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <memory>
#include <numbers>
#include <string>
#include <vector>

namespace spricka::test_front_growth {
namespace {

using namespace spricka::test;

constexpr double pi = std::numbers::pi;

// Irwin 1962, stress 1, at the parametric angle of x.
double K_of_ellipse(double a, double c, double phi) {
  double integral = 0.0; // of sqrt(sin^2 + (a/c)^2 cos^2) over a quarter
  constexpr int parts = 400;
  for (int i = 0; i < parts; ++i) {
    const double t = (i + 0.5) * 0.5 * pi / parts;
    integral += std::hypot(std::sin(t), a / c * std::cos(t)) * 0.5 * pi / parts;
  }
  return std::sqrt(pi * a) / integral *
         std::pow(std::pow(std::sin(phi), 2) + std::pow(a / c * std::cos(phi), 2), 0.25);
}

double K_at_ellipse(const growth::CrackGeometry& cracks, const Vec3& x) {
  const model::PlanarCrack& p = cracks.solids[0].plane;
  const Vec3 off = x - p.place;
  const double phi = std::atan2(off.y() / p.a, off.x() / p.c);
  return K_of_ellipse(p.a, p.c, phi);
}

// Arms and cycles of an ellipse until c has grown to `last`, in steps of a thousandth.
std::array<double, 3> integrated(double a, double c, double last) {
  double cycles = 0.0;
  const double dc = 1e-3 * c;
  while (c < last - 1e-9) {
    const auto ratio = [](double A, double C) {
      return paris(K_of_ellipse(A, C, 0.5 * pi), 0.0) / paris(K_of_ellipse(A, C, 0.0), 0.0);
    };
    const double half = a + 0.5 * dc * ratio(a, c);
    cycles += dc / paris(K_of_ellipse(half, c + 0.5 * dc, 0.0), 0.0);
    a += dc * ratio(half, c + 0.5 * dc);
    c += dc;
  }
  return {a, c, cycles};
}

double cycles_of(const growth::GrowthIntegrator& march) {
  return march.trajectory().cycles(march.growth_state().stations.front().s, march.growth_end()->s);
}

// An embedded ellipse has four arms, which grow alike, and its life is that of two numbers.
TEST(EllipticalFront, EmbeddedEllipseAsTwoNumbers) {
  Block block({-20, -20, -20}, {20, 20, 20}, 4);
  block.ellipse(Vec3::Zero(), 0.5, 1.0);
  block.model.growth->last_length = 1.5;
  growth::GrowthIntegrator march(block.model, paris,
                                 std::make_unique<growth::EllipticalFront>(block.model), {});
  ASSERT_EQ(march.tips().size(), 4U);
  EXPECT_EQ(march.tips()[0].name, "C.A1");
  EXPECT_EQ(march.tips()[3].name, "C.C2");
  run(march, K_at_ellipse);
  const auto [a, c, cycles] = integrated(0.5, 1.0, 1.5);
  EXPECT_STREQ(march.growth_end()->word(), "AMAX");
  EXPECT_NEAR(cycles_of(march) / cycles, 1.0, 1e-3);
  EXPECT_NEAR(march.growth_state().stations.back().tips[0].a / a, 1.0, 1e-3);
}

// A quarter of it in the corner of a block has two arms, and the same life but for what lies
// between the ends of the axes and the places ten degrees inside where K counts.
TEST(EllipticalFront, CornerCrackHasAnArmForEachAxis) {
  Block block({0, 0, -20}, {20, 20, 20}, 4);
  block.ellipse(Vec3::Zero(), 0.5, 1.0);
  block.model.growth->last_length = 1.5;
  growth::GrowthIntegrator march(block.model, paris,
                                 std::make_unique<growth::EllipticalFront>(block.model), {});
  ASSERT_EQ(march.tips().size(), 2U);
  EXPECT_EQ(march.tips()[0].name, "C.A");
  EXPECT_EQ(march.tips()[1].name, "C.C");
  run(march, K_at_ellipse);
  EXPECT_NEAR(cycles_of(march) / integrated(0.5, 1.0, 1.5)[2], 1.0, 5e-3);
}

// K larger on one side of the centre moves it: both ends of the axis keep their own rates.
TEST(EllipticalFront, ArmsOfOneAxisGrowApart) {
  Block block({-20, -20, -20}, {20, 20, 20}, 4);
  block.ellipse(Vec3::Zero(), 1.0, 1.0);
  block.model.growth->last_length = 1.3;
  growth::GrowthIntegrator march(block.model, paris,
                                 std::make_unique<growth::EllipticalFront>(block.model), {});
  growth::CrackGeometry last;
  run(march, [&](const growth::CrackGeometry& cracks, const Vec3& x) {
    last = cracks;
    return x.x() > 0.5 ? std::cbrt(3.0) : 1.0;
  });
  const std::vector<TipStation>& tips = march.growth_state().stations.back().tips;
  ASSERT_EQ(tips.size(), 4U);
  EXPECT_NEAR(tips[2].a, 1.3, 1e-9);
  EXPECT_NEAR(tips[3].a, 1.1, 1e-6);
  const model::PlanarCrack& plane = last.solids[0].plane;
  EXPECT_NEAR(plane.place.x(), 0.1, 1e-6);
  EXPECT_NEAR(plane.c, 1.2, 1e-6);
  EXPECT_NEAR(plane.a, 1.1, 1e-6);
}

// Through the far face of a plate: the front behind it leads from face to face, and the growth goes
// on to the edge.
template <class Ways> void through_the_plate() {
  Block block({0, 0, -20}, {20, 2, 20}, 4); // the plate is 2 thick along y
  block.ellipse(Vec3::Zero(), 1.0, 1.0);
  growth::GrowthIntegrator march(block.model, paris, std::make_unique<Ways>(block.model), {});
  std::vector<Vec3> ends;
  run(march, [&](const growth::CrackGeometry& cracks, const Vec3& x) {
    ends = cracks.aims;
    return 1.0 + 0.01 * x.y();
  });
  EXPECT_STREQ(march.growth_end()->word(), "EDGE");
  std::size_t leaps = 0;
  for (const growth::SolvedStation& station : march.growth_state().stations) {
    leaps += station.breakthroughs > 0 ? 1 : 0;
  }
  EXPECT_GE(leaps, 1U);
  double far = 0.0;
  for (const Vec3& x : ends) {
    far = std::max(far, x.x());
  }
  EXPECT_GT(far, 0.8 * 20.0);
  EXPECT_GT(march.cycle_error(), 0.0);
}
TEST(EllipticalFront, CornerCrackGoesThroughTheFarFace) {
  through_the_plate<growth::EllipticalFront>();
}
TEST(FreeFrontShape, CornerCrackGoesThroughTheFarFace) {
  through_the_plate<growth::FreeFrontShape>();
}

// The same K all round: a circle grows as one, in the body and from a corner.
TEST(FreeFrontShape, CircleStaysACircle) {
  for (const bool corner : {false, true}) {
    const double low = corner ? 0.0 : -20.0;
    Block block({low, low, -20}, {20, 20, 20}, 4);
    block.ellipse(Vec3::Zero(), 1.0, 1.0);
    block.model.growth->last_length = 2.0;
    growth::GrowthIntegrator march(block.model, paris,
                                   std::make_unique<growth::FreeFrontShape>(block.model), {});
    ASSERT_EQ(march.tips().size(), corner ? 17U : 32U);
    growth::CrackGeometry last;
    run(march, [&](const growth::CrackGeometry& cracks, const Vec3&) {
      last = cracks;
      return 1.0;
    });
    EXPECT_STREQ(march.growth_end()->word(), "AMAX");
    for (const Vec3& x : last.aims) {
      EXPECT_NEAR(x.norm(), 2.0, 2e-3) << x.transpose();
    }
    EXPECT_NEAR(cycles_of(march) / (1.0 / paris(1.0, 0.0)), 1.0, 1e-3);
  }
}

// An ellipse on its way to a circle: K of the ellipse that the front's own half-axes make. Five
// advances of a tenth of c (G22: a/c = 0.708 +- 0.005).
TEST(FreeFrontShape, EllipseBecomesRounder) {
  Block block({-20, -20, -20}, {20, 20, 20}, 4);
  block.ellipse(Vec3::Zero(), 0.5, 1.0);
  block.model.growth->last_length = 1.5;
  growth::GrowthIntegrator march(block.model, paris,
                                 std::make_unique<growth::FreeFrontShape>(block.model), {});
  double a = 0.0;
  double c = 0.0;
  run(march, [&](const growth::CrackGeometry& cracks, const Vec3& x) {
    a = c = 0.0;
    for (const Vec3& aim : cracks.aims) {
      a = std::max(a, std::abs(aim.y()));
      c = std::max(c, std::abs(aim.x()));
    }
    return K_of_ellipse(a, c, std::atan2(x.y() / a, x.x() / c));
  });
  const auto [end_a, end_c, cycles] = integrated(0.5, 1.0, c);
  EXPECT_NEAR(a / end_a, 1.0, 5e-3);
  EXPECT_NEAR(cycles_of(march) / cycles, 1.0, 1e-2);
}

// Two cracks that K is the same along all round grow as circles, meet, and go on as one, whose far
// sides know nothing of that; the notch between them fills.
struct Meeting {
  growth::CrackGeometry last;
  std::vector<std::size_t> met;
  std::string end;
  double error = 0.0;
};

Meeting two_that_meet(Block& block, double last_length) {
  block.model.growth->last_length = last_length;
  growth::GrowthIntegrator march(block.model, paris,
                                 std::make_unique<growth::FreeFrontShape>(block.model), {});
  Meeting out;
  run(march, [&](const growth::CrackGeometry& cracks, const Vec3&) {
    out.last = cracks;
    return 1.0;
  });
  for (const growth::SolvedStation& station : march.growth_state().stations) {
    if (station.met > 0) {
      out.met.push_back(station.met);
    }
  }
  out.end = march.growth_end()->word();
  out.error = march.cycle_error();
  return out;
}

TEST(FreeFrontShape, TwoCirclesGoOnAsOne) {
  for (const double normal : {1.0, -1.0}) { // of the second: faces up or down
    Block block({-20, -20, -20}, {20, 20, 20}, 4);
    block.ellipse({-1.3, 0, 0}, 1.0, 1.0, "C1");
    block.ellipse({1.3, 0, 0}, 1.0, 1.0, "C2");
    block.model.cracks[1].plane.normal *= normal;
    const Meeting both = two_that_meet(block, 2.5);
    EXPECT_EQ(both.end, "AMAX");
    ASSERT_EQ(both.met.size(), 1U);
    EXPECT_GT(both.error, 0.0);
    const std::size_t gone = both.met[0] - 1;
    EXPECT_TRUE(growth::is_merged(both.last.solids[gone]));
    EXPECT_FALSE(growth::is_merged(both.last.solids[1 - gone]));
    ASSERT_EQ(both.last.aims.size(), 64U);
    double far = 0.0;
    double waist = 1e300;
    for (std::size_t i = 0; i < both.last.aims.size(); ++i) {
      const Vec3& x = both.last.aims[i];
      EXPECT_EQ(both.last.fronts[i], 1 - gone);
      EXPECT_NEAR(x.z(), 0.0, 1e-12);
      far = std::max(far, std::abs(x.x()));
      waist = std::abs(x.x()) < 0.4 ? std::min(waist, std::abs(x.y())) : waist;
    }
    EXPECT_NEAR(far, 1.3 + 2.5, 0.02 * 3.8);
    // circles of 2.5 about the two centres cross at 2.14
    EXPECT_GT(waist, 2.0);
    EXPECT_LT(waist, 2.5);
  }
}

// On a free surface the front behind leads from the far end of one to the far end of the other.
TEST(FreeFrontShape, TwoSurfaceCracksGoOnAsOne) {
  Block block({-20, 0, -20}, {20, 20, 20}, 4);
  block.ellipse({-1.3, 0, 0}, 1.0, 1.0, "C1");
  block.ellipse({1.3, 0, 0}, 1.0, 1.0, "C2");
  const Meeting both = two_that_meet(block, 2.5);
  EXPECT_EQ(both.end, "AMAX");
  ASSERT_EQ(both.met.size(), 1U);
  ASSERT_EQ(both.last.aims.size(), 34U);
  double left = 0.0;
  double right = 0.0;
  for (const Vec3& x : both.last.aims) {
    left = std::min(left, x.x());
    right = std::max(right, x.x());
    EXPECT_GT(x.y(), -1e-6);
  }
  EXPECT_NEAR(left, -3.8, 0.1);
  EXPECT_NEAR(right, 3.8, 0.1);
}

// Cracks in two planes do not become one.
TEST(FreeFrontShape, CracksInTwoPlanesEndWhereTheyMeet) {
  Block block({-20, -20, -20}, {20, 20, 20}, 4);
  block.ellipse({-1.3, 0, 0}, 1.0, 1.0, "C1");
  block.ellipse({1.3, 0, 0.01}, 1.0, 1.0, "C2");
  EXPECT_EQ(two_that_meet(block, 2.5).end, "LINK-UP");
}

// Points that stay, of fronts that meet at one place; none where they meet at two.
TEST(JoinFronts, OneFrontOrNone) {
  const auto front = [](bool closed, std::vector<bool> stays, std::size_t first) {
    growth::CoalescingFront out{
        .points = {}, .tips = {}, .stays = std::move(stays), .closed = closed};
    for (std::size_t i = 0; i < out.stays.size(); ++i) {
      out.points.emplace_back(static_cast<double>(first + i), 0, 0);
      out.tips.push_back(first + i);
    }
    return out;
  };
  const auto ring = front(true, {true, false, false, true, true, true}, 0);
  const auto other_ring = front(true, {false, true, true, true, true, false}, 10);
  const auto rings = growth::coalesce_fronts(ring, other_ring);
  ASSERT_TRUE(rings);
  EXPECT_TRUE(rings->closed);
  EXPECT_EQ(rings->tips, (std::vector<std::size_t>{2, 3, 4, 5, 0, 1, 10, 11, 12, 13, 14, 15}));
  EXPECT_EQ(rings->points.size(), 8U);
  const auto left = front(false, {true, true, true, false}, 20);
  const auto right = front(false, {false, true, true, true}, 30);
  for (const bool turned : {false, true}) {
    const auto open =
        turned ? growth::coalesce_fronts(right, left) : growth::coalesce_fronts(left, right);
    ASSERT_TRUE(open);
    EXPECT_FALSE(open->closed);
    EXPECT_EQ(open->tips, (std::vector<std::size_t>{20, 21, 22, 23, 30, 31, 32, 33}));
  }
  const auto through =
      growth::coalesce_fronts(front(false, {true, true, false, true, true}, 40), ring);
  ASSERT_TRUE(through);
  EXPECT_FALSE(through->closed);
  EXPECT_EQ(through->tips.size(), 11U);
  EXPECT_FALSE(growth::coalesce_fronts(ring, left));
  EXPECT_FALSE(growth::coalesce_fronts(left, front(false, {true, true, false}, 50)));
  EXPECT_FALSE(growth::coalesce_fronts(front(true, {true, false, true, false}, 60), other_ring));
}

// A run that goes on from a station asks for the same front as one that never stopped.
template <class Ways> void goes_on_alike() {
  Block block({0, 0, -20}, {20, 2, 20}, 4);
  block.ellipse(Vec3::Zero(), 0.7, 1.0);
  block.model.growth->last_length = 4.0;
  growth::GrowthIntegrator whole(block.model, paris, std::make_unique<Ways>(block.model), {});
  base::Diagnostics none;
  for (int k = 0; k < 8; ++k) {
    const auto cracks = whole.propose_next_cracks(none);
    ASSERT_TRUE(cracks);
    const growth::GrowthState state =
        growth::growth_state_from_arrays(growth::growth_state_to_arrays(whole.growth_state()));
    growth::GrowthIntegrator again(block.model, paris, std::make_unique<Ways>(block.model), state);
    const auto same = again.propose_next_cracks(none);
    ASSERT_TRUE(same);
    ASSERT_EQ(same->aims.size(), cracks->aims.size());
    for (std::size_t i = 0; i < same->aims.size(); ++i) {
      EXPECT_EQ(same->aims[i], cracks->aims[i]) << "station " << k;
    }
    std::vector<TipStation> found(whole.tips().size());
    for (std::size_t tip = 0; tip < found.size(); ++tip) {
      const Vec3& x = cracks->aims[tip];
      found[tip].x = x.x();
      found[tip].y = x.y();
      found[tip].z = x.z();
      found[tip].K_max = 1.0 + 0.1 * x.y();
      found[tip].rate = paris(found[tip].K_max, 0.0);
    }
    whole.accept_or_reject_station(std::move(found));
  }
}
TEST(EllipticalFront, GoesOnAlike) {
  goes_on_alike<growth::EllipticalFront>();
}
TEST(FreeFrontShape, GoesOnAlike) {
  goes_on_alike<growth::FreeFrontShape>();
}

// Also behind the station where two cracks have become one.
TEST(FreeFrontShape, GoesOnAlikeAsOne) {
  Block block({-20, -20, -20}, {20, 20, 20}, 4);
  block.ellipse({-1.3, 0, 0}, 1.0, 1.0, "C1");
  block.ellipse({1.3, 0, 0}, 1.0, 1.0, "C2");
  block.model.growth->last_length = 2.5;
  growth::GrowthIntegrator whole(block.model, paris,
                                 std::make_unique<growth::FreeFrontShape>(block.model), {});
  base::Diagnostics none;
  std::size_t behind = 0;
  for (int k = 0; k < 60 && behind < 3; ++k) {
    const auto cracks = whole.propose_next_cracks(none);
    ASSERT_TRUE(cracks);
    const growth::GrowthState state =
        growth::growth_state_from_arrays(growth::growth_state_to_arrays(whole.growth_state()));
    growth::GrowthIntegrator again(block.model, paris,
                                   std::make_unique<growth::FreeFrontShape>(block.model), state);
    const auto same = again.propose_next_cracks(none);
    ASSERT_TRUE(same);
    for (std::size_t i = 0; i < same->aims.size(); ++i) {
      EXPECT_EQ(same->aims[i], cracks->aims[i]) << "station " << k;
      EXPECT_EQ(same->fronts[i], cracks->fronts[i]) << "station " << k;
    }
    std::vector<TipStation> found(whole.tips().size());
    for (std::size_t tip = 0; tip < found.size(); ++tip) {
      found[tip].K_max = 1.0 + 0.01 * cracks->aims[tip].y();
      found[tip].rate = paris(found[tip].K_max, 0.0);
    }
    whole.accept_or_reject_station(std::move(found));
    behind += behind > 0 || whole.growth_state().stations.back().met > 0 ? 1 : 0;
  }
  EXPECT_EQ(behind, 3U);
}

} // namespace
} // namespace spricka::test_front_growth
