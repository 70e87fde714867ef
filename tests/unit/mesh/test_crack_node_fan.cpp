// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/cut/crack_node_fan.hpp"

#include <gtest/gtest.h>

namespace spricka::test_crack_node_fan {
namespace {

using mesh::CrackFaceOfElement;

TEST(CrackNodeFan, ElementsFollowThoseTheyHangTogetherWith) {
  mesh::CrackNodeFan fan(5);
  fan.add_side_on_crack(0, CrackFaceOfElement::left);
  fan.add_side_on_crack(3, CrackFaceOfElement::right);
  fan.join_elements(0, 1);
  fan.join_elements(3, 2);
  EXPECT_EQ(
      fan.crack_face_of_each_element(),
      (std::vector{CrackFaceOfElement::left, CrackFaceOfElement::left, CrackFaceOfElement::right,
                   CrackFaceOfElement::right, CrackFaceOfElement::unknown}));
}

TEST(CrackNodeFan, ACrackThatEndsThereDoesNotPartThem) {
  mesh::CrackNodeFan fan(3);
  fan.add_side_on_crack(0, CrackFaceOfElement::left);
  fan.add_side_on_crack(2, CrackFaceOfElement::right);
  fan.join_elements(0, 1);
  fan.join_elements(1, 2);
  EXPECT_EQ(fan.crack_face_of_each_element(), std::vector(3, CrackFaceOfElement::both));
}

} // namespace
} // namespace spricka::test_crack_node_fan
