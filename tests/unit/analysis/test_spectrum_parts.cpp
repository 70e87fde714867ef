// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/unit/support/solved_text.hpp"
#include "tests/unit/support/strip_text.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>
#include <string>

/// What parts of a spectrum do to a life: K of the strip is proportional to the load.
namespace spricka::test_spectrum_parts {
namespace {

const std::string paris = "SPECTRUM=S LAW=PARIS AMAX=8 C=1e-11 M=3";

std::string with(const std::string& keys, const std::string& rows) {
  return test::strip_text(paris, "$LOADPATH NAME=UP FROM=ZERO TO=FULL\n$SPECTRUM NAME=S PATH=UP " +
                                     keys + "\n" + rows + "\n");
}

const results::OtherSpectrumLife* other_life(const results::GrowthResult& growth,
                                             const std::string& name) {
  for (const results::OtherSpectrumLife& other : growth.spectrum_parts.others) {
    if (other.name == name) {
      return &other;
    }
  }
  return nullptr;
}

// Each level grows as its cycles times the cube of their range.
TEST(SpectrumParts, SharesOfLevelsAreThoseOfTheLaw) {
  const auto solved = test::solve_text(with("TYPE=BLOCKS", "  0 1 1\n  0.2 0.8 20\n  0.5 0.8 100"));
  ASSERT_TRUE(solved && solved->run.growth);
  const results::SpectrumParts& parts = solved->run.growth->spectrum_parts;
  ASSERT_EQ(parts.peaks.size(), 2U);
  ASSERT_EQ(parts.ranges.size(), 3U);
  const double whole = 1.0 + 20.0 * 0.216 + 100.0 * 0.027;
  EXPECT_NEAR(parts.peaks[0].growth, 1.0 / whole, 1e-6);
  EXPECT_NEAR(parts.peaks[1].life, 1.0 - 1.0 / whole, 1e-6);
  EXPECT_NEAR(parts.ranges[2].growth, 2.7 / whole, 1e-6);
  EXPECT_EQ(parts.peaks[0].reached, 1.0);
  EXPECT_EQ(parts.peaks[1].reached, 121.0);
  EXPECT_EQ(parts.peaks[1].crossed, 121.0);
  EXPECT_EQ(parts.ranges[1].reached, 21.0);
}

// 0 to 1 and 0.5 to 0.8 by pairs, by rainflow too; 0 to 0.6 and 0.4 to 1 by pairs are 0 to 1 and
// 0.4 to 0.6 by rainflow.
TEST(SpectrumParts, TheOtherCountIsToldOf) {
  const auto solved = test::solve_text(with("TYPE=SEQUENCE COUNT=PAIRS", "  0 0.6 0.4 1"));
  const auto closed = test::solve_text(with("TYPE=SEQUENCE", "  0 0.6 0.4 1"));
  ASSERT_TRUE(solved && closed && solved->run.growth && closed->run.growth);
  const results::OtherSpectrumLife* other = other_life(*solved->run.growth, "COUNT=RAINFLOW");
  ASSERT_TRUE(other != nullptr && other->ratio);
  EXPECT_NEAR(*other->ratio, (0.216 + 0.216) / (1.0 + 0.008), 1e-6);
  EXPECT_NEAR(closed->run.growth->final_cycles() / solved->run.growth->final_cycles(),
              *other->ratio, 1e-3);
}

TEST(SpectrumParts, WhatClipAndOmitChange) {
  const auto solved =
      test::solve_text(with("TYPE=BLOCKS CLIP=80 OMIT=20 AT0=0 AT1=100 VALUES='MPa' FLIGHTS=50",
                            "  0 100 1\n  40 55 1000\n  20 70 10"));
  ASSERT_TRUE(solved && solved->run.growth);
  const results::GrowthResult& growth = *solved->run.growth;
  EXPECT_EQ(growth.cycles_per_pass, 11.0);
  const double own = std::pow(0.8, 3) + 10.0 * 0.125;
  const results::OtherSpectrumLife* unclipped = other_life(growth, "without CLIP");
  const results::OtherSpectrumLife* all = other_life(growth, "without OMIT");
  ASSERT_TRUE(unclipped != nullptr && all != nullptr && unclipped->ratio && all->ratio);
  EXPECT_NEAR(*unclipped->ratio, own / (1.0 + 1.25), 1e-6);
  EXPECT_NEAR(*all->ratio, own / (own + 1000.0 * std::pow(0.15, 3)), 1e-6);
  EXPECT_EQ(all->cycles_per_pass, 1011.0);
  EXPECT_EQ(growth.life_unit, "flights");
  EXPECT_EQ(growth.in_life_unit(2.0), 100.0);
}

} // namespace
} // namespace spricka::test_spectrum_parts
