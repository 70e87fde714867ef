// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/places.hpp"
#include "tests/unit/support/solved_text.hpp"
#include "tests/unit/support/strip_text.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <functional>
#include <numbers>
#include <sstream>
#include <vector>

#include <fmt/format.h>

/// Lives of decks whose cycles act on each other, against slow loops over the K that the run
/// prints, which share no code with the program.
namespace spricka::test_interaction_lives {
namespace {

using results::GrowthResult;
using results::GrowthStation;

/// A block of a spectrum: K of its loads at a tip of a station, and how many cycles.
struct Block {
  double low, high;
  int count;
};
using KOfLoad = std::function<double(std::size_t station, std::size_t tip, double load)>;

/// Wheeler's rule (1972) and the generalised one of Willenborg (1971; Gallagher 1974) with Walker's
/// law, as one reads them.
struct Rules {
  bool wheeler;
  double C = 1e-11, m = 3.0, gamma = 0.6; // mm, MPa mm^0.5
  double kappa = 0.5 * std::numbers::inv_pi, yield = 300.0;
  double w = 1.2, shut_off = 3.0, threshold = 60.0;

  struct Memory {
    double a = 0.0, zone = 0.0, K = 0.0;
  };

  [[nodiscard]] double law(double high, double low) const {
    const double R = std::max(low / high, 0.0);
    return high > 0.0
               ? C * std::pow((high - std::max(low, 0.0)) / std::pow(1.0 - R, 1.0 - gamma), m)
               : 0.0;
  }
  double growth(double a, double high, double low, Memory& at) const {
    const double zone = kappa * std::pow(high / yield, 2);
    if (a + zone >= at.a + at.zone) {
      at = {a, zone, high};
      return law(high, low);
    }
    if (wheeler) {
      return law(high, low) * std::pow(zone / (at.a + at.zone - a), w);
    }
    const double required = at.K * std::sqrt(1.0 - (a - at.a) / at.zone);
    const double off = (1.0 - threshold / high) / (shut_off - 1.0) * (required - high);
    return law(high - off, low - off);
  }
};

/// Passes from the first length to the last that the growth came to.
double slow_passes(const GrowthResult& growth, const std::vector<Block>& blocks,
                   const KOfLoad& K_of, const Rules& rules) {
  const std::vector<GrowthStation>& stations = growth.stations;
  const std::size_t tips = growth.point_names.size();
  std::vector<double> s_of;
  for (const GrowthStation& station : stations) {
    double s = 0.0;
    for (const auto& tip : station.points) {
      s += tip.a;
    }
    s_of.push_back(s);
  }
  // Through the four nearest stations, over ln s.
  const auto interpolated = [&](std::size_t i, double s, const auto& value) {
    const std::size_t n = stations.size();
    const std::size_t points = std::min<std::size_t>(4, n);
    const std::size_t before = (points - 1) / 2;
    const std::size_t first = std::min(std::max(i, before) - before, n - points);
    double sum = 0.0;
    for (std::size_t p = first; p < first + points; ++p) {
      double weight = 1.0;
      for (std::size_t q = first; q < first + points; ++q) {
        weight *= q == p ? 1.0 : std::log(s / s_of[q]) / std::log(s_of[p] / s_of[q]);
      }
      sum += weight * value(p);
    }
    return sum;
  };
  double top = 0.0;
  for (const Block& block : blocks) {
    top = std::max(top, block.high);
  }
  const auto arm = [&](std::size_t i, std::size_t tip, double s) {
    const auto share = [&](std::size_t k) {
      double all = 0.0;
      for (const auto& other : stations[k].points) {
        all += other.rate;
      }
      return stations[k].points[tip].rate / all;
    };
    const double h = s_of[i + 1] - s_of[i];
    const double t = (s - s_of[i]) / h;
    const double d = stations[i + 1].points[tip].a - stations[i].points[tip].a;
    return stations[i].points[tip].a + t * d +
           t * (1 - t) * ((1 - t) * (share(i) * h - d) + t * (d - share(i + 1) * h));
  };
  std::vector<Rules::Memory> memory(tips);
  double s = s_of.front();
  std::size_t i = 0;
  int per_pass = 0;
  for (const Block& block : blocks) {
    per_pass += block.count;
  }
  for (double cycles = 0.0;;) {
    for (const Block& block : blocks) {
      for (int n = 0; n < block.count; ++n) {
        while (i + 2 < s_of.size() && s > s_of[i + 1]) {
          ++i;
        }
        double ds = 0.0;
        for (std::size_t tip = 0; tip < tips; ++tip) {
          const double largest = std::exp(
              interpolated(i, s, [&](std::size_t k) { return std::log(K_of(k, tip, top)); }));
          const auto K = [&](double load) {
            return largest * interpolated(i, s, [&](std::size_t k) {
                     return K_of(k, tip, load) / K_of(k, tip, top);
                   });
          };
          ds += rules.growth(arm(i, tip, s), K(block.high), K(block.low), memory[tip]);
        }
        if (s + ds >= s_of.back()) {
          return (cycles + (s_of.back() - s) / ds) / per_pass;
        }
        s += ds;
        cycles += 1.0;
      }
    }
  }
}

std::string interactions(const std::string& first) {
  return "$INTERACTION NAME=WH TYPE=WHEELER W=1.2 ZONE=IRWIN2 YIELD=300\n"
         "$INTERACTION NAME=GW TYPE=WILLENBORG SOLR=3 MINIMUM=KEEP KTH=60 ZONE=IRWIN2 YIELD=300\n"
         "$GROW LAW=WALKER SPECTRUM=S KUNIT='MPa*mm^0.5' AUNIT='mm' C=1e-11 M=3 P=0.6 "
         "INTERACTION=" +
         first + (first == "WH" ? ",GW" : ",WH") + ",NONE ";
}

double compared_passes(const GrowthResult& growth, const std::string& name) {
  for (const results::ComparedLife& other : growth.compared) {
    if (other.name == name) {
      return other.curve.back().cycles;
    }
  }
  return 0.0;
}

void expect_slow_loop(const GrowthResult& growth, const std::string& first,
                      const std::vector<Block>& blocks, const KOfLoad& K_of, double tolerance) {
  ASSERT_EQ(growth.ended, "AMAX");
  const std::string other = first == "WH" ? "GW" : "WH";
  const Rules rules{.wheeler = first == "WH"};
  EXPECT_NEAR(growth.final_cycles() / slow_passes(growth, blocks, K_of, rules), 1.0, tolerance);
  EXPECT_NEAR(compared_passes(growth, other) /
                  slow_passes(growth, blocks, K_of, {.wheeler = other == "WH"}),
              1.0, tolerance);
  EXPECT_LT(compared_passes(growth, "NONE"), 0.9 * growth.final_cycles());
}

std::string blocks_text(const std::vector<Block>& blocks) {
  std::string text = "$SPECTRUM NAME=S PATH=UP TYPE=BLOCKS\n";
  for (const Block& block : blocks) {
    text += fmt::format("  {} {} {}\n", block.low, block.high, block.count);
  }
  return text;
}

// K of the path's load at the one tip in the plane.
KOfLoad path_K(const test::Solved& solved) {
  return [&solved](std::size_t station, std::size_t /*tip*/, double load) {
    return solved.run.increments[station].paths[0].fronts[0].single_point().K[0](load);
  };
}

TEST(InteractionLives, OfAPlateAreASlowLoop) {
  const std::vector<Block> blocks{{0.1, 1.5, 2}, {0.1, 1.0, 150}, {0.4, 0.9, 20}};
  for (const std::string first : {"WH", "GW"}) {
    std::string deck = test::strip_text("", "$LOADPATH NAME=UP FROM=ZERO TO=FULL BEYOND=1.6\n" +
                                                blocks_text(blocks));
    deck.replace(deck.find("$GROW"), std::string::npos,
                 interactions(first) + "CORRECT=NO AMAX=8\n$END\n");
    const auto solved = test::solve_text(deck);
    ASSERT_TRUE(solved && solved->run.growth);
    expect_slow_loop(*solved->run.growth, first, blocks, path_K(*solved), 1e-9);
  }
}

// Passes that stop the growth are those of the cycles one by one.
TEST(InteractionLives, CyclesStopTheGrowthWhereTheyAreOver) {
  const std::vector<Block> blocks{{0.1, 1.5, 2}, {0.1, 1.0, 150}};
  const auto life = [&](const std::string& end) {
    std::string deck = test::strip_text("", "$LOADPATH NAME=UP FROM=ZERO TO=FULL BEYOND=1.6\n" +
                                                blocks_text(blocks));
    deck.replace(deck.find("$GROW"), std::string::npos,
                 interactions("WH") + "CORRECT=NO " + end + "\n$END\n");
    return test::solve_text(deck);
  };
  const auto whole = life("AMAX=8");
  ASSERT_TRUE(whole && whole->run.growth);
  const double all = whole->run.growth->final_cycles();
  const auto part = life(fmt::format("AMAX=8 CYCLES={:.17g}", 0.6 * all));
  ASSERT_TRUE(part && part->run.growth);
  EXPECT_EQ(part->run.growth->ended, "CYCLES");
  EXPECT_NEAR(part->run.growth->final_cycles() / (0.6 * all), 1.0, 1e-9);
  EXPECT_NEAR(
      results::cycles_at_length(*whole->run.growth, 0, part->run.growth->curve.back().a[0]) /
          (0.6 * all),
      1.0, 1e-3); // other stations
}

// A K that is not proportional to the load: the paper's lug, press fit and pin.
TEST(InteractionLives, OfTheLugAreASlowLoop) {
  const std::filesystem::path decks = test::decks_folder();
  std::ifstream file(decks / "lug_spectrum.deck");
  std::stringstream text;
  text << file.rdbuf();
  std::string deck = text.str();
  ASSERT_FALSE(deck.empty());
  const std::vector<Block> blocks{{0.5, 1.0, 1}, {0.55, 0.75, 60}};
  const auto spectrum = deck.find("$SPECTRUM");
  deck.replace(spectrum, deck.find("$CRACK", spectrum) - spectrum, blocks_text(blocks));
  const auto include = deck.find("lug_model.inc");
  deck.replace(include, 13, (decks / "lug_model.inc").string());
  deck.replace(deck.find("$GROW"), std::string::npos,
               interactions("GW") + "CORRECT=NO AMAX=(0.4*R)\n$END\n");
  const auto solved = test::solve_text(deck);
  ASSERT_TRUE(solved && solved->run.growth);
  expect_slow_loop(*solved->run.growth, "GW", blocks, path_K(*solved), 1e-9);
}

// Behind a clamp that slips the strip feels 0.2 to 0.8 and twice 0.3 to 0.7 of the load: by
// Wheeler's rule the smaller ones grow (0.7/0.8)^2 times as much.
TEST(InteractionLives, WithFrictionASettledPassStandsForAll) {
  std::ifstream file(std::filesystem::path(test::decks_folder()) / "friction_life.deck");
  std::stringstream text;
  text << file.rdbuf();
  std::string deck = text.str();
  ASSERT_FALSE(deck.empty());
  const auto spectrum = deck.find("$SPECTRUM");
  deck.replace(spectrum, std::string::npos,
               "$SPECTRUM NAME=PASS PATH=UP TYPE=SEQUENCE\n  1 0 0.9 0.1 0.9 0.1\n"
               "$INTERACTION NAME=WH TYPE=WHEELER W=1 KAPPA=0.16 YIELD=300\n"
               "$GROW LAW=PARIS SPECTRUM=PASS INTERACTION=WH,NONE C=(C0) M=3 AMAX=(0.3*W) "
               "KUNIT='MPa*mm^0.5' AUNIT='mm'\n$END\n");
  const auto solved = test::solve_text(deck);
  ASSERT_TRUE(solved && solved->run.growth);
  const double large = std::pow(0.6, 3);
  const double small = 2.0 * std::pow(0.4, 3);
  const double held_back = std::pow(0.7 / 0.8, 2);
  EXPECT_NEAR(compared_passes(*solved->run.growth, "NONE") / solved->run.growth->final_cycles() /
                  ((large + held_back * small) / (large + small)),
              1.0, 2e-3);
}

// Two ends of the axes of an ellipse: each remembers for itself.
TEST(InteractionLives, OfAnEllipseAreASlowLoop) {
  const std::vector<Block> blocks{{0.1, 1.0, 1}, {0.1, 0.6, 100}};
  const std::string deck = R"($DECK VERSION=1 LENGTH=mm FORCE=N
$NET NAME=BAR
  $MESH SHAPE=BLOCK TYPE=TET10 X0=-6 Y0=-4 Z0=-3 LX=12 LY=8 LZ=6 NX=3 NY=2 NZ=2
$ENDNET
$MATERIAL NAME=M  E=2000 NU=0
$PROPERTY ESET=BAR.BODY MATERIAL=M STATE=SOLID
$FREEDOM CLASS=SUPPRESSED DOF=XYZ
  BAR.XMIN
$CRACK NAME=C1 NET=BAR A=1 X0=0 Y0=0 Z0=0 NORMAL=X
$LOAD CASE=PULL TYPE=TRACTION
  BAR.XMAX  150 0 0
$STEP NAME=REST
  LOAD PULL 0
$STEP NAME=FULL
  LOAD PULL 1
$LOADPATH NAME=UP FROM=REST TO=FULL
)" + blocks_text(blocks) + interactions("WH") +
                           "SHAPE=ELLIPSE CORRECT=NO AMAX=1.15 TOL=0.05\n$END\n";
  const auto solved = test::solve_text(deck);
  ASSERT_TRUE(solved && solved->run.growth);
  const GrowthResult& growth = *solved->run.growth;
  // K is proportional to the load there
  expect_slow_loop(
      growth, "WH", blocks,
      [&](std::size_t station, std::size_t tip, double load) {
        return load * growth.stations[station].points[tip].K_max;
      },
      1e-8);
}

// A rule that the law does not serve, or that has no zone, is told of.
TEST(InteractionLives, WhatTheLawDoesNotServeIsRefused) {
  const auto messages = [](const std::string& card, const std::string& grow) {
    std::string deck = test::strip_text("", "$LOADPATH NAME=UP FROM=ZERO TO=FULL\n" +
                                                blocks_text({{0.1, 0.9, 3}}));
    deck.replace(deck.find("$GROW"), std::string::npos,
                 card + "\n$GROW KUNIT='MPa*mm^0.5' AUNIT='mm' C=1e-11 M=3 AMAX=8 " + grow +
                     "\n$END\n");
    const test::Folder folder;
    return test::run_text(folder, deck).messages;
  };
  const std::string zone = " ZONE=IRWIN2 YIELD=300";
  const std::string willenborg = "$INTERACTION NAME=W TYPE=WILLENBORG SOLR=3 MINIMUM=KEEP" + zone;
  const std::string wheeler = "$INTERACTION NAME=W TYPE=WHEELER W=1";
  const std::string chang = "$INTERACTION NAME=W TYPE=CHANG SOLR=3 KTH=60 Q=0.3" + zone;
  const std::array cases{
      std::array<std::string, 3>{willenborg, "LAW=PARIS SPECTRUM=S INTERACTION=W", "E341"},
      std::array<std::string, 3>{chang, "LAW=WALKER P=0.5 DKTH=60 SPECTRUM=S INTERACTION=W",
                                 "E341"},
      std::array<std::string, 3>{"$INTERACTION NAME=W TYPE=CLOSURE",
                                 "LAW=WALKER P=0.5 SPECTRUM=S INTERACTION=W", "E341"},
      std::array<std::string, 3>{wheeler + " YIELD=300", "LAW=PARIS SPECTRUM=S INTERACTION=W",
                                 "E106"},
      std::array<std::string, 3>{wheeler + zone, "LAW=PARIS KMAX=FULL KMIN=ZERO INTERACTION=W",
                                 "E106"},
      std::array<std::string, 3>{wheeler + zone, "LAW=PARIS SPECTRUM=S INTERACTION=V", "E301"},
      std::array<std::string, 3>{wheeler + zone, "LAW=PARIS SPECTRUM=S INTERACTION=W,W", "E110"},
      std::array<std::string, 3>{wheeler + zone, "LAW=PARIS SPECTRUM=S", "W357"}};
  for (const auto& [card, grow, code] : cases) {
    const std::string told = messages(card, grow);
    EXPECT_NE(told.find(code), std::string::npos) << card << "\n" << told;
  }
}

} // namespace
} // namespace spricka::test_interaction_lives
