// SPDX-License-Identifier: GPL-3.0-or-later
// What goes wrong unseen where the mouth of a crack lies in a contact: faces of the tube's ends
// left out of the surface, one multiplier for both lips.
#include "tests/unit/analysis/front_decks.hpp"
#include "tests/unit/support/solved_scene.hpp"

#include <cmath>
#include <set>

namespace spricka::test_front_pitfalls {
namespace {

// The punch is coarser than the cracked body, which carries the multipliers.
test::SolvedScene pressed() {
  std::string text = test::pressed_mouth("$STEP NAME=S\n  LOAD PRESS 1\n  LOAD PULL 1\n");
  const std::string fine = "NX=4 NY=4 NZ=2";
  text.replace(text.find(fine), fine.size(), "NX=2 NY=2 NZ=1");
  return test::SolvedScene(text);
}

// The cracked body's surface is whole below the punch: the areas of all hats on it, covered or not,
// are that of the block's upper side.
TEST(FrontPitfalls, TheContactSurfaceHasTheEndsOfTheTube) {
  const test::SolvedScene solved = pressed();
  ASSERT_FALSE(solved.scene().pairs[0].swapped) << solved.scene().pairs[0].choice;
  double whole = 0.0;
  double covered = 0.0;
  for (const contact::MultiplierFunction& function : solved.scene().pairs[0].functions) {
    whole += function.whole;
    covered += function.area;
  }
  EXPECT_NEAR(whole, 64.0, 1e-9 * 64.0);
  EXPECT_NEAR(covered, 16.0, 1e-9 * 16.0);
}

// Both lips of the mouth carry a multiplier of their own on each node that is not the front's.
TEST(FrontPitfalls, EachLipHasItsOwnPressure) {
  const test::SolvedScene solved = pressed();
  const model::Mesh& mesh = solved.scene().cracked.mesh;
  std::size_t on_mouth = 0;
  for (const auto& [upper, lower] : solved.scene().cracked.faces[0].coincident_node_pairs()) {
    if (std::abs(mesh.x[upper.index()].z()) > 1e-9) {
      continue;
    }
    ++on_mouth;
    std::set<int> rows;
    for (const contact::MultiplierFunction& function : solved.scene().pairs[0].functions) {
      if (function.node == upper || function.node == lower) {
        EXPECT_GE(function.row, 0);
        rows.insert(function.row);
      }
    }
    EXPECT_EQ(rows.size(), 2U) << mesh.x[upper.index()].transpose();
  }
  EXPECT_GT(on_mouth, 8U);
}

} // namespace
} // namespace spricka::test_front_pitfalls
