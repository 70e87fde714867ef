// SPDX-License-Identifier: GPL-3.0-or-later
#include "deck_text.hpp"
#include "model/model.hpp"

#include <algorithm>

#include <gtest/gtest.h>

namespace spricka::deck::test_sets {
namespace {

// Two rows of four nodes; net B is the same, moved by 10 along x.
const std::string k_mesh =
    "$COOR DIM=2\n"
    " 1 (o+0) 0\n 2 (o+1) 0\n 3 (o+2) 0\n 4 (o+3) 0\n"
    " 11 (o+0) 1\n 12 (o+1) 1\n 13 (o+2) 1\n 14 (o+3) 1\n"
    "$ELEMENT TYPE=QUAM4 ESET=BODY\n 1 1 2 12 11\n 2 2 3 13 12\n 3 3 4 14 13\n"
    "$PROPERTY ESET=BODY MATERIAL=M STATE=STRESS\n";

class Sets : public testing::Test {
protected:
  std::optional<model::Model> read(const std::string& cards) {
    std::string second = k_mesh;
    for (std::size_t at = second.find("(o+"); at != std::string::npos; at = second.find("(o+")) {
      second.replace(at, 3, "(10+");
    }
    reading.emplace(folder, "$DECK VERSION=1 LENGTH=mm FORCE=N\n$PARAMETER\n o = 0\n"
                            "$MATERIAL NAME=M E=1 NU=0\n$NET NAME=A\n" +
                                k_mesh + "$ENDNET\n$NET NAME=B\n" + second + "$ENDNET\n" + cards +
                                "$END\n");
    return std::move(reading->model);
  }
  /// Node numbers of a set, those of net B plus 100.
  static std::vector<int> nodes(const model::Model& model, const std::string& name) {
    std::vector<int> labels;
    for (const model::NodeSet& set : model.mesh.node_sets) {
      for (std::size_t i = 0; set.name == name && i < set.nodes.size(); ++i) {
        const std::size_t n = set.nodes[i].index();
        labels.push_back(static_cast<int>(model.mesh.node_label[n]) +
                         (model.mesh.node_net[n].index() == 2 ? 100 : 0));
      }
    }
    return labels;
  }
  Folder folder;
  std::optional<Reading> reading;
};

using V = std::vector<int>;

TEST_F(Sets, OutsideNetsTheySelectFromAllNets) {
  const auto m = read("$NSET NAME=LEFT WHERE=(x < 0.5 or x == 10)\n"
                      "$NET NAME=C\n$ENDNET\n");
  ASSERT_TRUE(m) << reading->messages();
  EXPECT_EQ(nodes(*m, "LEFT"), (V{1, 11, 101, 111}));
}

TEST_F(Sets, OrderIsThatOfTheItemsOrOfOrder) {
  const auto m = read("$NSET NAME=P\n A.Q\n"
                      "$NSET NAME=BACK FROM=P ORDER=(-x)\n"
                      "$NSET NAME=MORE WHERE=(y == 0 and x < 9) ORDER=(abs(x-1.9))\n"
                      "$NET NAME=C\n$ENDNET\n");
  EXPECT_FALSE(m); // A.Q is nowhere
  EXPECT_EQ(reading->codes(), "E301");
  const auto n = read("$NSET NAME=BACK FROM=LINE ORDER=(-x)\n" // before its definition
                      "$NSET NAME=LINE WHERE=(y == 0 and x < 9)\n"
                      "$NSET NAME=NEAR FROM=LINE ORDER=(abs(x-1.9))\n");
  ASSERT_TRUE(n) << reading->messages();
  EXPECT_EQ(nodes(*n, "BACK"), (V{4, 3, 2, 1}));
  EXPECT_EQ(nodes(*n, "NEAR"), (V{3, 2, 4, 1}));
}

TEST_F(Sets, NumbersBelongToTheOpenNet) {
  EXPECT_FALSE(read("$NSET NAME=P\n 1\n"));
  EXPECT_EQ(reading->codes(), "E303");
  EXPECT_NE(reading->messages().find("between $NET and $ENDNET"), std::string::npos);
}

// A pressure from x = 0.5 on, where the mesh has edges from 1 to 3: both lengths are told.
TEST_F(Sets, ABorderWithinFacesOfALoadIsTold) {
  const std::string load = "$LOAD CASE=L TYPE=PRESSURE\n P 1\n";
  ASSERT_TRUE(read("$FSET NAME=P WHERE=(y == 1 and x > 0.5 and x < 9)\n" + load));
  EXPECT_NE(reading->messages().find("W372"), std::string::npos) << reading->messages();
  EXPECT_NE(reading->messages().find("2 mm in all, and its condition holds on 2.5 mm"),
            std::string::npos)
      << reading->messages();
  // Whole edges; and a strip of the sides of a bore or a corner is none of the surface.
  for (const char* where : {"y == 1 and x > 0.999 and x < 9", "y > 0.6 and x < 9"}) {
    ASSERT_TRUE(read("$FSET NAME=P WHERE=(" + std::string(where) + ")\n" + load));
    EXPECT_EQ(reading->messages().find("W372"), std::string::npos) << reading->messages();
  }
}

TEST(SetItems, RangesRemovalAndEachOnce) {
  const Folder folder;
  const Reading r(folder, k_square + "$NSET NAME=A\n 4  1 : 3 : 2, 1\n"
                                     "$NSET NAME=B\n A 2 -A 3\n$END\n");
  ASSERT_TRUE(r.model) << r.messages();
  const auto labels = [&](std::size_t set) {
    V all;
    for (const base::NodeId n : r.model->mesh.node_sets[set].nodes) {
      all.push_back(static_cast<int>(r.model->mesh.node_label[n.index()]));
    }
    return all;
  };
  EXPECT_EQ(labels(0), (V{4, 1, 3}));
  EXPECT_EQ(labels(1), (V{2, 3}));
}

TEST(SetItems, FacesAndNodesStandForEachOther) {
  const Folder folder;
  const Reading r(folder, k_square + "$NSET NAME=BOTTOM\n 1 2\n"
                                     "$FSET NAME=F\n BOTTOM\n"
                                     "$FSET NAME=G WHERE=(x == 1)\n"
                                     "$FREEDOM CLASS=SUPPRESSED DOF=XY\n F\n"
                                     "$LOAD CASE=C TYPE=PRESSURE\n BOTTOM 2\n G (y)\n$END\n");
  ASSERT_TRUE(r.model) << r.messages();
  const model::Mesh& mesh = r.model->mesh;
  ASSERT_EQ(r.model->freedoms.size(), 1U);
  EXPECT_EQ(mesh.set_with_id(r.model->freedoms[0].nodes).nodes.size(), 2U);
  const auto& loads = r.model->cases.at(0).loads;
  ASSERT_EQ(loads.size(), 2U);
  ASSERT_EQ(mesh.set_with_id(loads[0].faces).faces.size(), 1U);
  EXPECT_EQ(mesh.set_with_id(loads[0].faces).faces[0].side, 0);
  EXPECT_EQ(mesh.set_with_id(loads[1].faces).faces[0].side, 1);
  EXPECT_FALSE(loads[1].value[0].is_constant());
}

} // namespace
} // namespace spricka::deck::test_sets
