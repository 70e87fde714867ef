// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/cut/crack_node_fan.hpp"

#include <gtest/gtest.h>

namespace spricka::test_crack_node_fan {
namespace {

using mesh::CrackFaceOfElement;

TEST(CrackNodeFan, ElementsFollowThoseTheyHangTogetherWith) {
  mesh::CrackNodeFan fan(5);
  fan.mark(0, CrackFaceOfElement::left);
  fan.mark(3, CrackFaceOfElement::right);
  fan.join(0, 1);
  fan.join(3, 2);
  EXPECT_EQ(fan.sides(), (std::vector{CrackFaceOfElement::left, CrackFaceOfElement::left,
                                      CrackFaceOfElement::right, CrackFaceOfElement::right,
                                      CrackFaceOfElement::unknown}));
}

TEST(CrackNodeFan, ACrackThatEndsThereDoesNotPartThem) {
  mesh::CrackNodeFan fan(3);
  fan.mark(0, CrackFaceOfElement::left);
  fan.mark(2, CrackFaceOfElement::right);
  fan.join(0, 1);
  fan.join(1, 2);
  EXPECT_EQ(fan.sides(), std::vector(3, CrackFaceOfElement::both));
}

} // namespace
} // namespace spricka::test_crack_node_fan
