// SPDX-License-Identifier: GPL-3.0-or-later
#include "program/peers/calculix.hpp"

#include <cmath>

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace spricka::test_calculix {
namespace {

using program::read_calculix_results;

// A block of values as ccx writes it, of two nodes.
std::string block(const std::string& name, double a, double b, int count) {
  std::string text =
      fmt::format(" -4  {:<8}    {}    1\n -5  D1          1    2    1    0\n", name, count);
  for (const auto& [node, first] : {std::pair{7, a}, std::pair{1000000, b}}) {
    text += fmt::format(" -1{:>10}", node);
    for (int c = 0; c < count; ++c) {
      text += fmt::format("{:12.5E}", first + c);
    }
    text += "\n";
  }
  return text + " -3\n";
}

TEST(Calculix, ValuesAreReadByTheirNodes) {
  const std::string text = "    1C\n" + block("DISP", 1.0, -4.0, 3) +
                           block("STRESS", 10.0, -20.0, 6) + block("FORC", 99.0, 99.0, 3);
  const auto fields = read_calculix_results(text, {1000000, 3, 7}, 3);
  ASSERT_TRUE(fields);
  EXPECT_EQ(fields->u.segment(0, 3), base::Vec3(-4, -3, -2));
  EXPECT_TRUE(std::isnan(fields->u[3])) << "node 3 is not in the file";
  EXPECT_EQ(fields->u.segment(6, 3), base::Vec3(1, 2, 3));
  EXPECT_EQ(fields->stress[2], (results::Stress{10, 11, 12, 13, 14, 15}));
  EXPECT_EQ(fields->stress[0][5], -15.0);
}

TEST(Calculix, OfSeveralBlocksTheLastCounts) {
  const std::string text = block("DISP", 1.0, 2.0, 3) + block("STRESS", 1.0, 2.0, 6) +
                           block("DISP", 5.0, 6.0, 3) + block("STRESS", 5.0, 6.0, 6);
  const auto fields = read_calculix_results(text, {7, 1000000}, 2);
  ASSERT_TRUE(fields);
  EXPECT_EQ(fields->u.size(), 4);
  EXPECT_EQ(fields->u[0], 5.0);
  EXPECT_EQ(fields->stress[1][0], 6.0);
}

// A run that was stopped, or has failed, leaves part of a file.
TEST(Calculix, ATornFileIsNoAnswer) {
  const std::string whole = block("DISP", 1.0, 2.0, 3) + block("STRESS", 1.0, 2.0, 6);
  for (std::size_t length = 0; length < whole.size(); ++length) {
    const auto fields = read_calculix_results(whole.substr(0, length), {7, 1000000}, 3);
    if (fields) {
      EXPECT_GT(length, whole.find("STRESS"));
    }
  }
  EXPECT_FALSE(read_calculix_results("", {1, 2}, 3));
  EXPECT_FALSE(read_calculix_results("no results\n", {1, 2}, 3));
}

TEST(Calculix, PlaneElementsAreAskedForAtTheirOwnNodes) {
  const std::string inp = "*NODE FILE\nU, RF\n*EL FILE\nS\n*END STEP\n";
  EXPECT_EQ(program::adapt_input_for_calculix(inp, 3), inp);
  EXPECT_EQ(program::adapt_input_for_calculix(inp, 2),
            "*NODE FILE, OUTPUT=2D\nU, RF\n*EL FILE, OUTPUT=2D\nS\n*END STEP\n");
}

} // namespace
} // namespace spricka::test_calculix
