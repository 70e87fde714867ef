// SPDX-License-Identifier: GPL-3.0-or-later
#include "deck/labels.hpp"
#include "deck/names.hpp"

#include <gtest/gtest.h>

namespace spricka::deck::test_names {
namespace {

Definition of(Kind kind, std::size_t index) {
  Definition definition;
  definition.kind = kind;
  definition.index = index;
  return definition;
}

TEST(Names, ANetsOwnSetsComeFirst) {
  Names names;
  names.define("BORE", of(Kind::node_set, 0));
  names.define("LUG.BORE", of(Kind::node_set, 1));
  EXPECT_EQ(names.find({Kind::node_set}, "BORE", "")->index, 0U);
  EXPECT_EQ(names.find({Kind::node_set}, "BORE", "LUG")->index, 1U);
  EXPECT_EQ(names.find({Kind::node_set}, "BORE", "PIN")->index, 0U);
  EXPECT_EQ(names.find({Kind::node_set}, "LUG.BORE", "PIN")->index, 1U);
  EXPECT_EQ(names.find({Kind::face_set}, "BORE", ""), nullptr);
}

TEST(Names, TheWantedKindComesFirst) {
  Names names;
  names.define("A", of(Kind::node_set, 0));
  names.define("A", of(Kind::face_set, 1));
  EXPECT_EQ(names.find(meanings(Kind::face_set), "A", "")->index, 1U);
  EXPECT_EQ(names.find(meanings(Kind::node_set), "A", "")->index, 0U);
}

TEST(Names, ASecondDefinitionDoesNotCount) {
  Names names;
  EXPECT_EQ(names.define("A", of(Kind::step, 0)), nullptr);
  EXPECT_EQ(names.define("A", of(Kind::step, 5))->index, 0U);
  EXPECT_EQ(names.define("A", of(Kind::crack, 0)), nullptr);
}

TEST(Names, HintsKnowOtherNets) {
  Names names;
  names.define("HUB.BODY", of(Kind::element_set, 0));
  EXPECT_EQ(names.hint({Kind::element_set}, "BODY"), "did you mean 'HUB.BODY'?");
  names.define("PIN.BODY", of(Kind::element_set, 1));
  EXPECT_EQ(names.hint({Kind::element_set}, "BODY"), "one of: HUB.BODY, PIN.BODY");
}

TEST(Labels, NearAndFarNumbers) {
  Labels labels;
  for (std::size_t i = 0; i < 5000; ++i) {
    EXPECT_TRUE(labels.insert(static_cast<base::Label>(10 * i + 1), i));
  }
  EXPECT_TRUE(labels.insert(1000000000001, 5000));
  EXPECT_FALSE(labels.insert(1000000000001, 1));
  EXPECT_FALSE(labels.insert(49991, 1));
  EXPECT_FALSE(labels.insert(1, 1));
  EXPECT_EQ(labels.find(49991), 4999U);
  EXPECT_EQ(labels.find(1000000000001), 5000U);
  EXPECT_FALSE(labels.find(2));
  EXPECT_FALSE(labels.find(-7));
  EXPECT_EQ(labels.highest(), 1000000000001);
}

} // namespace
} // namespace spricka::deck::test_names
