// SPDX-License-Identifier: GPL-3.0-or-later
#include "deck/labels.hpp"
#include "deck/names.hpp"

#include <gtest/gtest.h>

namespace spricka::deck::test_names {
namespace {

NameDefinition of(EntityKind kind, std::size_t index) {
  NameDefinition definition;
  definition.kind = kind;
  definition.index = index;
  return definition;
}

TEST(NameTable, ANetsOwnSetsComeFirst) {
  NameTable names;
  names.define("BORE", of(EntityKind::node_set, 0));
  names.define("LUG.BORE", of(EntityKind::node_set, 1));
  EXPECT_EQ(names.find({EntityKind::node_set}, "BORE", "")->index, 0U);
  EXPECT_EQ(names.find({EntityKind::node_set}, "BORE", "LUG")->index, 1U);
  EXPECT_EQ(names.find({EntityKind::node_set}, "BORE", "PIN")->index, 0U);
  EXPECT_EQ(names.find({EntityKind::node_set}, "LUG.BORE", "PIN")->index, 1U);
  EXPECT_EQ(names.find({EntityKind::face_set}, "BORE", ""), nullptr);
}

TEST(NameTable, TheWantedKindComesFirst) {
  NameTable names;
  names.define("A", of(EntityKind::node_set, 0));
  names.define("A", of(EntityKind::face_set, 1));
  EXPECT_EQ(names.find(accepted_kinds(EntityKind::face_set), "A", "")->index, 1U);
  EXPECT_EQ(names.find(accepted_kinds(EntityKind::node_set), "A", "")->index, 0U);
}

TEST(NameTable, ASecondDefinitionDoesNotCount) {
  NameTable names;
  EXPECT_EQ(names.define("A", of(EntityKind::step, 0)), nullptr);
  EXPECT_EQ(names.define("A", of(EntityKind::step, 5))->index, 0U);
  EXPECT_EQ(names.define("A", of(EntityKind::crack, 0)), nullptr);
}

TEST(NameTable, HintsKnowOtherNets) {
  NameTable names;
  names.define("HUB.BODY", of(EntityKind::element_set, 0));
  EXPECT_EQ(names.similar_name_hint({EntityKind::element_set}, "BODY"), "did you mean 'HUB.BODY'?");
  names.define("PIN.BODY", of(EntityKind::element_set, 1));
  EXPECT_EQ(names.similar_name_hint({EntityKind::element_set}, "BODY"),
            "one of: HUB.BODY, PIN.BODY");
}

TEST(LabelMap, NearAndFarNumbers) {
  LabelMap labels;
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
