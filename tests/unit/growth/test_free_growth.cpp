// SPDX-License-Identifier: GPL-3.0-or-later
#include "exact_front.hpp"
#include "growing_block.hpp"
#include "growth/free_front_shape.hpp"
#include "tests/places.hpp"

#include <cmath>
#include <cstdlib>
#include <memory>
#include <numbers>
#include <vector>

namespace spricka::test_free_growth {
namespace {

using namespace spricka::test;

/// An embedded ellipse of `ratio` by 1 that grows freely by da/dN = K^m until its longer axis is
/// `last`, and what tests/bench/free_front.py has for it.
struct HashStateDeleter {
  double ratio, m, last;
  double cycles, shape;       ///< the truth
  double of_cycles, of_shape; ///< parts that may be missed with TOL=0.02
  int points;
  bool half = false;
};

mesh::FrontCurve curve_of(const model::CrackDefinition& crack, bool half) {
  std::vector<Vec3> points = crack.points;
  if (crack.kind == model::CrackDefinitionKind::ellipse) {
    for (int i = 0; i < 240; ++i) {
      const double phi = 2.0 * std::numbers::pi * i / 240;
      points.emplace_back(crack.plane.c * std::cos(phi), crack.plane.a * std::sin(phi), 0.0);
    }
  }
  if (half) { // of an open front what lies in the body, and its mirror image
    std::vector<Vec3> in;
    for (std::size_t i = 0; i < points.size(); ++i) {
      const Vec3& x = points[i];
      const bool ellipse = crack.kind == model::CrackDefinitionKind::ellipse;
      if (i > 0 && !ellipse && (x.y() > 0.0) != (points[i - 1].y() > 0.0)) {
        const Vec3& y = points[i - 1];
        in.emplace_back(x + x.y() / (x.y() - y.y()) * (y - x));
        in.back().y() = 0.0;
      }
      if (x.y() > (ellipse ? -1e-12 : 1e-3)) {
        in.push_back(x);
      }
    }
    points = in;
    for (std::size_t i = in.size() - 2; i > 0; --i) {
      points.emplace_back(in[i].x(), -in[i].y(), 0.0);
    }
  }
  const std::vector<Vec3> normals(points.size(), Vec3::UnitZ());
  return {points, normals, true};
}

void grows_as(const HashStateDeleter& truth) {
  Block block({-20, truth.half ? 0.0 : -20.0, -20}, {20, 20, 20}, 4);
  block.ellipse(Vec3::Zero(), truth.ratio, 1.0);
  block.model.growth->last_length = truth.last;
  block.model.growth->tolerance = 0.02;
  block.model.growth->constants.m = truth.m;
  const auto law = [&](double K, double /*K_min*/, const model::PlaceOnCrack& /*place*/) {
    return std::pow(K, truth.m);
  };
  growth::GrowthIntegrator march(block.model, law,
                                 std::make_unique<growth::FreeFrontShape>(block.model), {});
  ExactFront exact(truth.points);
  exact.flatten(truth.ratio);
  const Vec3 nowhere(1e9, 0, 0);
  Vec3 solved = nowhere;
  std::vector<Vec3> aims;
  run(
      march,
      [&](const growth::CrackGeometry& cracks, const Vec3& x) {
        if (cracks.aims.front() != solved) { // of all tips the first
          exact.move_to(curve_of(cracks.solids[0], truth.half));
          solved = cracks.aims.front();
        }
        aims = cracks.aims;
        return exact.K_at(x);
      },
      law);
  ASSERT_STREQ(march.growth_end()->word(), "AMAX");
  double a = 0.0;
  double c = 0.0;
  for (const Vec3& x : aims) {
    a = std::max(a, std::abs(x.y()));
    c = std::max(c, std::abs(x.x()));
  }
  const double cycles =
      march.trajectory().cycles(march.growth_state().stations.front().s, march.growth_end()->s);
  EXPECT_NEAR(cycles / truth.cycles, 1.0, truth.of_cycles);
  EXPECT_NEAR(a / c / truth.shape, 1.0, truth.of_shape);
  EXPECT_LT(std::abs(cycles / truth.cycles - 1.0), march.cycle_error());
  EXPECT_LT(march.cycle_error(), 0.02);
  EXPECT_LT(march.growth_state().stations.size(), 12U);
}

// Its life is 1.6 % longer than that of an ellipse that stays one.
TEST(FreeGrowth, OfAnEllipseIsTheTrueOne) {
  grows_as({0.5, 3, 1.15, 0.2320557, 0.709149, 3e-3, 3e-3, 64});
}

// Half of it, as a surface crack whose K is that of the whole: the same, by an open front.
TEST(FreeGrowth, OfHalfAnEllipseIsTheTrueOne) {
  grows_as({0.5, 3, 1.15, 0.2320557, 0.709149, 3e-3, 3e-3, 64, true});
  grows_as({0.5, 4, 1.15, 0.2457220, 0.758326, 3e-3, 3e-3, 64, true});
}

// Longer, steeper, flatter.
TEST(FreeGrowth, OfOtherEllipsesIsTheTrueOne) {
  if (!test::full_size()) {
    GTEST_SKIP() << "with SPRICKA_FULL=1";
  }
  grows_as({0.5, 3, 1.5, 0.4690921, 0.869814, 3e-3, 3e-3, 96});
  grows_as({0.5, 4, 1.15, 0.2457220, 0.758326, 3e-3, 3e-3, 96});
  grows_as({0.5, 3, 1.5, 0.4690921, 0.869814, 3e-3, 3e-3, 96, true});
  grows_as({0.2, 3, 1.15, 0.59619, 0.6531, 5e-3, 5e-3, 160});
}

} // namespace
} // namespace spricka::test_free_growth
