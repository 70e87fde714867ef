// SPDX-License-Identifier: GPL-3.0-or-later
#include "growth/growth_integrator.hpp"
#include "growth/planar_tips.hpp"
#include "model/model.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <numbers>

namespace spricka::test_growth_integrator {
namespace {

using base::Vec3;
using growth::TipStation;

constexpr double pi = std::numbers::pi;

/// A rectangle of quadrilaterals with cracks in it: the march needs its edges and its cracks only;
/// K comes from a formula.
struct Plate {
  model::Model model;

  Plate(double x0, double width, double height, int n) {
    model::Mesh& mesh = model.mesh;
    for (int j = 0; j <= n; ++j) {
      for (int i = 0; i <= n; ++i) {
        model::add_node(mesh, {x0 + width * i / n, height * (2.0 * j / n - 1.0), 0.0},
                        static_cast<base::Label>(mesh.node_count()) + 1, base::NetId(0));
      }
    }
    const auto node = [&](int i, int j) {
      return base::NodeId(static_cast<std::size_t>(j * (n + 1) + i));
    };
    for (int j = 0; j < n; ++j) {
      for (int i = 0; i < n; ++i) {
        const std::array nodes{node(i, j), node(i + 1, j), node(i + 1, j + 1), node(i, j + 1)};
        model::add_element(mesh, base::ElementType::quam4, nodes,
                           static_cast<base::Label>(mesh.element_count()) + 1, base::NetId(0));
      }
    }
    mesh.property.assign(mesh.element_count(), base::PropertyId(0));
    model.nets.push_back({"", {}});
    model.properties.emplace_back();
    model.growth.emplace();
    model.growth->law = model::CrackGrowthLaw::paris;
    model.growth->tolerance = 1e-4;
  }

  // A straight crack along x; between two points inside it has two tips.
  void crack(const std::string& name, double from, double to, double y = 0.0) {
    model::CrackDefinition crack;
    crack.name = name;
    crack.kind = model::CrackDefinitionKind::free;
    crack.net = base::NetId(0);
    crack.points = {{from, y, 0.0}, {to, y, 0.0}};
    model.cracks.push_back(crack);
  }

  std::unique_ptr<growth::CrackKinematics> kinematics() {
    std::vector<mesh::CrackLine> out;
    for (std::size_t c = 0; c < model.cracks.size(); ++c) {
      mesh::CrackLine line;
      line.crack = base::CrackId(c);
      line.name = model.cracks[c].name;
      line.net = base::NetId(0);
      line.points = model.cracks[c].points;
      line.embedded = std::abs(line.points.front().x() - model.mesh.x.front().x()) > 1e-9;
      out.push_back(line);
    }
    return std::make_unique<growth::PlanarTips>(model, std::move(out));
  }
};

using Measure =
    std::function<void(const growth::GrowthIntegrator& march,
                       const std::vector<mesh::CrackLine>& lines, std::vector<TipStation>& tips)>;

void run(growth::GrowthIntegrator& march, const Measure& measure) {
  base::Diagnostics diagnostics;
  for (int k = 0; k < 200 && !march.growth_end(); ++k) {
    const auto lines = march.propose_next_cracks(diagnostics);
    if (!lines) {
      break;
    }
    std::vector<TipStation> found(march.tips().size());
    measure(march, lines->lines, found);
    march.accept_or_reject_station(std::move(found));
  }
  EXPECT_FALSE(diagnostics.has_errors());
  ASSERT_TRUE(march.growth_end()) << "no end after 200 stations";
}

double tip_x(const mesh::CrackLine& line) {
  return line.points.back().x();
}

double cycles_of(const growth::GrowthIntegrator& march) {
  return march.trajectory().cycles(march.growth_state().stations.front().s, march.growth_end()->s);
}

// Benchmark G01: da/dN = 1e-11 dK^3, dS = 100, beta = 1.12, a from 1 to 10.
TEST(GrowthIntegrator, LifeOfTheBenchmark) {
  Plate plate(0.0, 100.0, 50.0, 10);
  plate.crack("C", 0.0, 1.0);
  plate.model.growth->last_length = 10.0;
  const growth::GrowthRateFunction paris = [](double K_max, double K_min,
                                              const model::PlaceOnCrack& /*place*/) {
    return 1e-11 * std::pow(K_max - K_min, 3);
  };
  growth::GrowthIntegrator march(plate.model, paris, plate.kinematics(), {});
  run(march, [&](const auto&, const auto& lines, auto& tips) {
    tips[0].K_max = 112.0 * std::sqrt(pi * tip_x(lines[0]));
    tips[0].rate = paris(tips[0].K_max, 0.0, {});
  });
  EXPECT_STREQ(march.growth_end()->word(), "AMAX");
  EXPECT_NEAR(cycles_of(march) / 17480.85136, 1.0, 1e-6);
  EXPECT_LE(march.growth_state().stations.size(), 12U);
}

// Edge crack by Tada's formula: stations as far apart as the tolerance lets them be, the error
// within it and within what the march says of itself.
TEST(GrowthIntegrator, KeepsItsTolerance) {
  const auto K = [](double a) {
    const double r = a / 20.0;
    const double c = std::cos(0.5 * pi * r);
    return 50.0 * std::sqrt(40.0 * std::tan(0.5 * pi * r)) *
           (0.752 + 2.02 * r + 0.37 * std::pow(1.0 - std::sin(0.5 * pi * r), 3)) / c;
  };
  const growth::GrowthRateFunction paris = [](double K_max, double K_min,
                                              const model::PlaceOnCrack& /*place*/) {
    return 1e-12 * std::pow(K_max - K_min, 3.5);
  };
  double exact = 0.0;
  constexpr int parts = 20000;
  for (int k = 0; k < parts; ++k) {
    exact += 15.0 / parts / paris(K(1.0 + 15.0 * (k + 0.5) / parts), 0.0, {});
  }
  std::size_t fewer = 0;
  for (const double tolerance : {1e-2, 1e-3, 1e-4}) {
    Plate plate(0.0, 20.0, 50.0, 10);
    plate.crack("C", 0.0, 1.0);
    plate.model.growth->last_length = 16.0;
    plate.model.growth->tolerance = tolerance;
    growth::GrowthIntegrator march(plate.model, paris, plate.kinematics(), {});
    run(march, [&](const auto&, const auto& lines, auto& tips) {
      tips[0].K_max = K(tip_x(lines[0]));
      tips[0].rate = paris(tips[0].K_max, 0.0, {});
    });
    const double missed = std::abs(cycles_of(march) / exact - 1.0);
    EXPECT_LE(missed, tolerance);
    EXPECT_LE(missed, march.cycle_error());
    EXPECT_LE(march.cycle_error(), 10.0 * tolerance);
    EXPECT_LE(march.growth_state().stations.size(), 30U);
    EXPECT_GE(march.growth_state().stations.size(), fewer);
    fewer = march.growth_state().stations.size();
  }
}

// Two arms that grow at their own rates, rate_i = c_i a_i: exponentials with a known ratio.
TEST(GrowthIntegrator, TipsGrowAtTheirOwnRates) {
  Plate plate(-100.0, 200.0, 50.0, 10);
  plate.crack("C", -1.0, 1.0);
  plate.model.growth->last_length = 6.0;
  growth::GrowthIntegrator march(plate.model, {}, plate.kinematics(), {});
  run(march, [&](const auto&, const auto& lines, auto& tips) {
    tips[0].rate = 1e-4 * -lines[0].points.front().x();
    tips[1].rate = 2e-4 * tip_x(lines[0]);
    tips[0].K_max = tips[1].K_max = 1.0;
  });
  ASSERT_STREQ(march.growth_end()->word(), "AMAX");
  const growth::SolvedStation& last = march.growth_state().stations.back();
  EXPECT_NEAR(last.tips[1].a, 6.0, 1e-9);
  EXPECT_NEAR(cycles_of(march) / (std::log(6.0) / 2e-4), 1.0, 1e-3);
  EXPECT_NEAR(last.tips[0].a / std::sqrt(6.0), 1.0, 1e-3);
}

// K rises past the toughness: the end lies where it reaches it, not at a station.
TEST(GrowthIntegrator, EndsAtToughness) {
  Plate plate(0.0, 1000.0, 50.0, 10);
  plate.crack("C", 0.0, 1.0);
  plate.model.growth->constants.k_c = 500.0;
  const growth::GrowthRateFunction forman = [](double K_max, double,
                                               const model::PlaceOnCrack& /*place*/) {
    return K_max < 500.0 ? 1e-9 * std::pow(K_max, 3) / (500.0 - K_max)
                         : std::numeric_limits<double>::infinity();
  };
  growth::GrowthIntegrator march(plate.model, forman, plate.kinematics(), {});
  run(march, [&](const auto&, const auto& lines, auto& tips) {
    tips[0].K_max = 100.0 * std::sqrt(tip_x(lines[0]));
    tips[0].rate = forman(tips[0].K_max, 0.0, {});
  });
  EXPECT_STREQ(march.growth_end()->word(), "KC");
  EXPECT_NEAR(march.growth_end()->s, 25.0, 1e-6);
  // integral of (500 - 100 sqrt a) / (1e-9 1e6 a^1.5) da from 1 to 25
  EXPECT_NEAR(cycles_of(march) / (1e3 * (1000.0 * 0.8 - 100.0 * std::log(25.0))), 1.0, 1e-4);
}

TEST(GrowthIntegrator, EndsAfterItsCycles) {
  Plate plate(0.0, 1000.0, 50.0, 10);
  plate.crack("C", 0.0, 1.0);
  plate.model.growth->cycles = 1e4;
  const growth::GrowthRateFunction law = [](double K_max, double,
                                            const model::PlaceOnCrack& /*place*/) {
    return 1e-4 * K_max * K_max;
  };
  growth::GrowthIntegrator march(plate.model, law, plate.kinematics(), {});
  run(march, [&](const auto&, const auto& lines, auto& tips) {
    tips[0].K_max = std::sqrt(tip_x(lines[0]));
    tips[0].rate = law(tips[0].K_max, 0.0, {});
  });
  EXPECT_STREQ(march.growth_end()->word(), "CYCLES");
  EXPECT_NEAR(march.growth_end()->s, std::exp(1.0), 1e-6);
}

// K falls with the length, as behind a hole: growth stops where its range reaches the threshold.
TEST(GrowthIntegrator, EndsAtTheThreshold) {
  Plate plate(0.0, 1000.0, 50.0, 10);
  plate.crack("C", 0.0, 1.0);
  const growth::GrowthRateFunction law = [](double K_max, double,
                                            const model::PlaceOnCrack& /*place*/) {
    return K_max > 0.5 ? 1e-4 * K_max : 0.0;
  };
  growth::GrowthIntegrator march(plate.model, law, plate.kinematics(), {});
  run(march, [&](const auto&, const auto& lines, auto& tips) {
    tips[0].K_max = 1.0 / tip_x(lines[0]);
    tips[0].rate = law(tips[0].K_max, 0.0, {});
  });
  EXPECT_STREQ(march.growth_end()->word(), "THRESHOLD");
  EXPECT_NEAR(march.growth_end()->s, 2.0, 1e-5);
  EXPECT_NEAR(cycles_of(march) / 1.5e4, 1.0, 1e-3); // integral of a / 1e-4 from 1 to 2
}

TEST(GrowthIntegrator, NothingGrows) {
  Plate plate(0.0, 10.0, 5.0, 10);
  plate.crack("C", 0.0, 1.0);
  for (const double K : {1.0, 0.0}) {
    growth::GrowthIntegrator march(plate.model, {}, plate.kinematics(), {});
    run(march, [&](const auto&, const auto&, auto& tips) { tips[0].K_max = K; });
    EXPECT_STREQ(march.growth_end()->word(), K > 0.0 ? "THRESHOLD" : "CLOSED");
    EXPECT_EQ(cycles_of(march), 0.0);
  }
}

// K falls to 0 at twice the length and stays there: the crack closes for good.
TEST(GrowthIntegrator, EndsWhereTheCrackCloses) {
  Plate plate(0.0, 1000.0, 50.0, 10);
  plate.crack("C", 0.0, 1.0);
  const growth::GrowthRateFunction law = [](double K_max, double,
                                            const model::PlaceOnCrack& /*place*/) {
    return K_max > 0.0 ? 1e-4 : 0.0;
  };
  growth::GrowthIntegrator march(plate.model, law, plate.kinematics(), {});
  run(march, [&](const auto&, const auto& lines, auto& tips) {
    tips[0].K_max = std::max(0.0, 2.0 - tip_x(lines[0]));
    tips[0].rate = law(tips[0].K_max, 0.0, {});
  });
  EXPECT_STREQ(march.growth_end()->word(), "CLOSED");
  EXPECT_NEAR(march.growth_end()->s, 2.0, 0.05);
}

// Rates that fall without end and never to 0.
TEST(GrowthIntegrator, ComesToRest) {
  Plate plate(0.0, 1000.0, 50.0, 10);
  plate.crack("C", 0.0, 1.0);
  growth::GrowthIntegrator march(plate.model, {}, plate.kinematics(), {});
  run(march, [&](const auto&, const auto& lines, auto& tips) {
    tips[0].K_max = 1.0;
    tips[0].rate = 1e-3 * std::exp(-10.0 * (tip_x(lines[0]) - 1.0));
  });
  EXPECT_STREQ(march.growth_end()->word(), "ARREST");
  EXPECT_NEAR(march.growth_end()->s, 1.0 + 0.9 * std::log(10.0), 0.3);
}

// Round and round a spiral from radius 20 inward: nothing but the turn ends it.
TEST(GrowthIntegrator, EndsWhereTheCrackCurls) {
  Plate plate(-40.0, 100.0, 50.0, 20);
  plate.crack("C", -40.0, 2.0);
  plate.model.growth->direction = model::GrowthDirection::hoop;
  plate.model.growth->largest_advance = 2.0;
  growth::GrowthIntegrator march(plate.model, {}, plate.kinematics(), {});
  run(march, [](const auto&, const auto& lines, auto& tips) {
    const std::vector<Vec3>& p = lines[0].points;
    const Vec3 radius = p.back() - Vec3(2.0, 20.0, 0.0);
    const Vec3 now = p.back() - p[p.size() - 2];
    constexpr double inward = 0.05;
    tips[0].turn = std::remainder(
        std::atan2(radius.x(), -radius.y()) + inward - std::atan2(now.y(), now.x()), 2.0 * pi);
    tips[0].K_max = 1.0;
    tips[0].rate = 1e-4;
  });
  EXPECT_STREQ(march.growth_end()->word(), "CURL");
  EXPECT_LT(march.growth_end()->s, 42.0 + 2.0 * pi * 20.0);
  EXPECT_GT(march.growth_end()->s, 42.0 + 2.0 * pi * 20.0 * std::exp(-2.0 * pi * 0.05));
}

TEST(GrowthIntegrator, MeetsTheEdge) {
  Plate plate(0.0, 10.0, 5.0, 10);
  plate.crack("C", 0.0, 1.0, 0.3);
  model::FaceSet right;
  right.name = "XMAX";
  for (std::size_t e = 9; e < 100; e += 10) {
    right.faces.push_back({base::ElementId(e), 1});
  }
  plate.model.mesh.face_sets.push_back(right);
  growth::GrowthIntegrator march(plate.model, {}, plate.kinematics(), {});
  run(march, [](const auto&, const auto& lines, auto& tips) {
    tips[0].K_max = 1.0;
    tips[0].rate = 1e-3 / (10.0 - tip_x(lines[0]));
  });
  EXPECT_STREQ(march.growth_end()->word(), "EDGE");
  EXPECT_NE(march.growth_end()->reason.find("XMAX"), std::string::npos)
      << march.growth_end()->reason;
  EXPECT_GT(march.growth_end()->s, 9.7);
}

// Two cracks on one line grow towards each other.
TEST(GrowthIntegrator, CracksLinkUp) {
  Plate plate(0.0, 20.0, 5.0, 10);
  plate.crack("LEFT", 0.0, 2.0);
  plate.crack("RIGHT", 8.0, 14.0);
  growth::GrowthIntegrator march(plate.model, {}, plate.kinematics(), {});
  run(march, [](const auto&, const auto&, auto& tips) {
    for (TipStation& tip : tips) {
      tip.K_max = 1.0;
      tip.rate = 1e-4;
    }
  });
  EXPECT_STREQ(march.growth_end()->word(), "LINK-UP");
  const growth::SolvedStation& last = march.growth_state().stations.back();
  EXPECT_LT(last.tips[1].x - last.tips[0].x, 0.12);
  EXPECT_GT(last.tips[1].x, last.tips[0].x);
}

// A crack whose heading is known everywhere: it must follow the circle, and better with shorter
// advances, by the second order.
TEST(GrowthIntegrator, FollowsACurve) {
  std::vector<double> off;
  for (const double da : {1.0, 0.5}) {
    Plate plate(-18.0, 100.0, 50.0, 20);
    plate.crack("C", -18.0, 2.0);
    plate.model.growth->direction = model::GrowthDirection::hoop;
    plate.model.growth->largest_advance = da;
    plate.model.growth->last_length = 40.0;
    growth::GrowthIntegrator march(plate.model, {}, plate.kinematics(), {});
    run(march, [](const auto&, const auto& lines, auto& tips) {
      // circles about (2, 20): the way on at any point is across its radius
      const std::vector<Vec3>& p = lines[0].points;
      const Vec3 radius = p.back() - Vec3(2.0, 20.0, 0.0);
      const Vec3 now = p.back() - p[p.size() - 2];
      tips[0].turn = std::remainder(
          std::atan2(radius.x(), -radius.y()) - std::atan2(now.y(), now.x()), 2.0 * pi);
      tips[0].K_max = 1.0;
      tips[0].rate = 1e-4;
    });
    ASSERT_STREQ(march.growth_end()->word(), "AMAX");
    const growth::TipStation& last = march.growth_state().stations.back().tips[0];
    off.push_back(std::abs(std::hypot(last.x - 2.0, last.y - 20.0) - 20.0));
  }
  EXPECT_LT(off[0], 0.05);
  EXPECT_LT(off[1], 0.3 * off[0]);
}

// A state written out and read back goes on to the same numbers, to the bit.
TEST(GrowthIntegrator, GoesOnFromItsState) {
  const growth::GrowthRateFunction paris = [](double K_max, double K_min,
                                              const model::PlaceOnCrack& /*place*/) {
    return 1e-10 * std::pow(K_max - K_min, 3);
  };
  const Measure measure = [&](const auto&, const auto& lines, auto& tips) {
    const double a = tip_x(lines[0]);
    tips[0].K_max = 100.0 * std::sqrt(pi * a) * (1.0 + 0.1 * a * a);
    tips[0].K_min = 10.0;
    tips[0].rate = paris(tips[0].K_max, tips[0].K_min, {});
  };
  Plate plate(0.0, 100.0, 50.0, 10);
  plate.crack("C", 0.0, 1.0);
  plate.model.growth->last_length = 10.0;
  growth::GrowthIntegrator whole(plate.model, paris, plate.kinematics(), {});
  run(whole, measure);
  growth::GrowthIntegrator first(plate.model, paris, plate.kinematics(), {});
  base::Diagnostics diagnostics;
  for (int k = 0; k < 4; ++k) {
    std::vector<TipStation> found(1);
    measure(first, first.propose_next_cracks(diagnostics)->lines, found);
    first.accept_or_reject_station(std::move(found));
  }
  const growth::GrowthState read =
      growth::growth_state_from_arrays(growth::growth_state_to_arrays(first.growth_state()));
  growth::GrowthIntegrator second(plate.model, paris, plate.kinematics(), read);
  run(second, measure);
  ASSERT_EQ(second.growth_state().stations.size(), whole.growth_state().stations.size());
  for (std::size_t i = 0; i < whole.growth_state().stations.size(); ++i) {
    EXPECT_EQ(second.growth_state().stations[i].s, whole.growth_state().stations[i].s);
    EXPECT_EQ(second.growth_state().stations[i].tips[0].K_max,
              whole.growth_state().stations[i].tips[0].K_max);
  }
  EXPECT_EQ(cycles_of(second), cycles_of(whole));
}

} // namespace
} // namespace spricka::test_growth_integrator
