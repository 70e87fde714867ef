// SPDX-License-Identifier: GPL-3.0-or-later
#include "deck_text.hpp"
#include "model/model.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace spricka::deck::test_meshes {
namespace {

const std::string k_head = "$DECK VERSION=1 LENGTH=mm FORCE=N\n";
const std::string k_steel = "$MATERIAL NAME=STEEL E=210[GPa] NU=0.3\n";

const model::FaceSet& faces(const model::Model& model, const std::string& name) {
  return *std::find_if(model.mesh.face_sets.begin(), model.mesh.face_sets.end(),
                       [&](const model::FaceSet& s) { return s.name == name; });
}

TEST(Meshes, ABlockInSpaceIsBuiltWithItsSets) {
  for (const char* type : {"TET10", "HEXE8", "HEXEC20", "HEXEC27"}) {
    const Folder folder;
    const Reading reading(folder, k_head + k_steel + "$MESH SHAPE=BLOCK TYPE=" + type +
                                      " LX=2 LY=1 LZ=3 NX=2 NY=1 NZ=2\n"
                                      "$PROPERTY ESET=BODY MATERIAL=STEEL STATE=SOLID\n"
                                      "$NSET NAME=AXIS WHERE=(x==0 and y==0) ORDER=(z)\n"
                                      "$FSET NAME=HALF FROM=ZMAX WHERE=(x<=1)\n"
                                      "$FSET NAME=REST\n ZMAX, -HALF\n"
                                      "$FREEDOM CLASS=SUPPRESSED DOF=XYZ\n ZMIN\n$END\n");
    ASSERT_TRUE(reading.model) << type << reading.messages();
    const model::Model& model = *reading.model;
    EXPECT_EQ(model.mesh.dim, 3);
    const std::size_t all = faces(model, "ZMAX").faces.size();
    EXPECT_EQ(2 * faces(model, "HALF").faces.size(), all);
    EXPECT_EQ(2 * faces(model, "REST").faces.size(), all);
    EXPECT_EQ(model.mesh.node_sets[0].nodes.size(), std::string(type) == "HEXE8" ? 3U : 5U);
    EXPECT_TRUE(model.unavailable.empty());
  }
}

TEST(Meshes, ElementsInSpaceFromTables) {
  const Folder folder;
  const std::string table = "$COOR\n 1 0 0 0\n 2 1 0 0\n 3 0 1 0\n 4 0 0 1\n";
  const Reading good(folder, k_head + k_steel + table +
                                 "$ELEMENT TYPE=TET4 ESET=E\n 1 1 2 3 4\n"
                                 "$FSET NAME=FOOT WHERE=(z==0)\n"
                                 "$PROPERTY ESET=E MATERIAL=STEEL STATE=SOLID\n$END\n");
  ASSERT_TRUE(good.model) << good.messages();
  EXPECT_EQ(faces(*good.model, "FOOT").faces,
            (std::vector<model::Face>{{base::ElementId(std::size_t{0}), 0}}));
  const Reading turned(folder, k_head + k_steel + table +
                                   "$ELEMENT TYPE=TET4 ESET=E\n 1 1 3 2 4\n"
                                   "$PROPERTY ESET=E MATERIAL=STEEL STATE=SOLID\n$END\n");
  EXPECT_EQ(turned.codes(), "E307") << turned.messages();
  const Reading mixed(folder, k_head + k_steel + table +
                                  "$ELEMENT TYPE=TET4 ESET=E\n 1 1 2 3 4\n"
                                  "$ELEMENT TYPE=TRIM3 ESET=F\n 2 1 2 3\n"
                                  "$PROPERTY ESET=E MATERIAL=STEEL STATE=SOLID\n"
                                  "$PROPERTY ESET=F MATERIAL=STEEL STATE=STRESS\n$END\n");
  EXPECT_EQ(mixed.codes(), "E313") << mixed.messages();
}

const std::string k_inp = "*NODE\n1,0,0\n2,1,0\n3,1,1\n4,0,1\n*ELEMENT,TYPE=CPE4,ELSET=PLATE\n"
                          "1,1,2,3,4\n*SURFACE,NAME=FOOT\nPLATE,S1\n*MATERIAL,NAME=ALU\n*ELASTIC\n"
                          "70000,0.33\n*SOLID SECTION,ELSET=PLATE,MATERIAL=ALU\n2.\n";

TEST(Meshes, AnInputFileBringsMaterialAndProperty) {
  const Folder folder;
  folder.write("p.inp", k_inp);
  const Reading reading(folder,
                        k_head + k_steel +
                            "$NET NAME=A\n$IMPORT FILE='p.inp' FORMAT=INP\n"
                            "$FREEDOM CLASS=SUPPRESSED DOF=XY\n FOOT\n$ENDNET\n"
                            "$MESH SHAPE=BLOCK TYPE=QUAM4 LX=1 LY=1 X0=5\n"
                            "$PROPERTY ESET=BODY MATERIAL=A.ALU STATE=STRESS THICK=2\n$END\n");
  ASSERT_TRUE(reading.model) << reading.messages();
  const model::Model& model = *reading.model;
  ASSERT_EQ(model.materials.size(), 2U);
  EXPECT_EQ(model.materials[1].name, "A.ALU");
  for (std::size_t e = 0; e < model.mesh.element_count(); ++e) {
    EXPECT_EQ(model.element_material(model.mesh, base::ElementId(e)).E, 70000.0);
  }
  EXPECT_EQ(model.element_property(model.mesh, base::ElementId(std::size_t{0})).state,
            model::StressState::plane_strain);
  EXPECT_TRUE(model.unavailable.empty());
}

TEST(Meshes, APropertyForElementsThatHaveOneIsAnError) {
  const Folder folder;
  folder.write("p.inp", k_inp);
  const Reading reading(folder, k_head + k_steel +
                                    "$IMPORT FILE='p.inp' FORMAT=INP\n"
                                    "$PROPERTY ESET=PLATE MATERIAL=STEEL STATE=STRESS\n$END\n");
  EXPECT_EQ(reading.codes(), "E306") << reading.messages();
}

TEST(Meshes, WhatAnInputFileMayNotSayIsToldAtTheCard) {
  const Folder folder;
  folder.write("p.inp", k_inp + "*BOUNDARY\n1,1,2\n*STEP\n*STATIC\n*END STEP\n");
  const std::string deck = k_head + "$IMPORT FILE='p.inp' FORMAT=INP\n"
                                    "$FREEDOM CLASS=SUPPRESSED DOF=XY\n FOOT\n$END\n";
  const Reading refused(folder, deck);
  EXPECT_EQ(refused.codes(), "E336 E336 E336") << refused.messages();
  EXPECT_NE(refused.messages().find("test.deck:2:1: error E336: p.inp:15: *BOUNDARY"),
            std::string::npos)
      << refused.messages();
  folder.write("p.inp", k_inp + "*EQUATION\n2\n1,1,1.,2,1,-1.\n");
  const Reading tied(folder, deck);
  ASSERT_TRUE(tied.model) << tied.messages();
  ASSERT_EQ(tied.model->mpcs.size(), 1U);
  const auto& equation = std::get<model::ConstraintEquation>(tied.model->mpcs[0]);
  ASSERT_EQ(equation.terms.size(), 2U);
  EXPECT_EQ(equation.terms[1].coefficient, -1.0);
  const Reading raised(folder, k_head + "$IMPORT FILE='p.inp' FORMAT=INP TYPE=QUADRATIC\n$END\n");
  EXPECT_EQ(raised.codes(), "E110") << raised.messages();
}

// Element 4 of the solid patch of MacNeal and Harder, as printed and with its node 13 moved.
TEST(Meshes, ASlightlyFoldedCornerOfASolidIsTold) {
  const Folder folder;
  const auto brick = [&](const std::string& y) {
    return Reading(folder, "$DECK VERSION=1 LENGTH=mm FORCE=N\n$COOR\n 1 0 0 0\n 2 1 0 0\n"
                           " 5 0 0 1\n 6 1 0 1\n 9 0.249 0.342 0.192\n 10 0.826 0.288 0.288\n"
                           " 13 0.320 " +
                               y +
                               " 0.643\n 14 0.677 0.305 0.683\n"
                               "$ELEMENT TYPE=HEXE8 ESET=E\n 4 1 2 10 9 5 6 14 13\n"
                               "$MATERIAL NAME=M E=1 NU=0\n$PROPERTY ESET=E MATERIAL=M "
                               "STATE=SOLID\n$END\n");
  };
  const Reading printed = brick("0.186");
  EXPECT_TRUE(printed.model);
  EXPECT_NE(printed.messages().find("W307: element 4 folds over in its corner at node 13: its "
                                    "Jacobian there is -8.3 % of the mean"),
            std::string::npos)
      << printed.messages();
  EXPECT_EQ(brick("0.286").messages(), "");
  EXPECT_EQ(brick("0.17").codes(), "E307");
}

} // namespace
} // namespace spricka::deck::test_meshes
