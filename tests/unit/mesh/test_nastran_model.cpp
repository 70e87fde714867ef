// SPDX-License-Identifier: GPL-3.0-or-later
#include "meshes.hpp"
#include "nastran_file.hpp"
#include "shape/topology.hpp"

#include <gtest/gtest.h>

#include <fmt/format.h>

namespace spricka::test_nastran_model {
namespace {

using test::Nastran;
using test::samples;
using test::square;
using test::tetrahedron;
using test::text_of;

TEST_F(Nastran, MaterialsByAnyTwoConstantsAndPropertiesOfSolids) {
  const std::string solid = tetrahedron + "PSOLID,5,2\nPARAM,WTMASS,0.5\n";
  for (const char* constants : {"210000.,,.25,8.-9,1.2-5", "210000.,84000.,,8.-9,1.2-5",
                                ",84000.,.25,8.-9,1.2-5", "210000.,84000.,.25,8.-9,1.2-5"}) {
    ASSERT_TRUE(import(solid + "MAT1,2," + constants + "\n")) << messages();
    ASSERT_EQ(model_.materials.size(), 1U);
    EXPECT_EQ(model_.materials[0].name, "M2");
    EXPECT_NEAR(model_.materials[0].E, 210000.0, 1e-9);
    EXPECT_NEAR(model_.materials[0].nu, 0.25, 1e-15);
    EXPECT_EQ(model_.materials[0].rho, 4e-9); // half of it, by WTMASS
    EXPECT_EQ(model_.materials[0].alpha, 1.2e-5);
    ASSERT_EQ(model_.properties.size(), 1U);
    EXPECT_EQ(model_.properties[0].state, model::StressState::solid);
    EXPECT_TRUE(model_.mesh.property[0].valid());
  }
}

TEST_F(Nastran, PropertiesOfAnEmptyMaterialAreLeftToTheDeck) {
  ASSERT_TRUE(import(tetrahedron + "PSOLID,5,2\nMAT1,2,,,,0.,0.,0.\n")) << messages();
  EXPECT_TRUE(model_.materials.empty());
  EXPECT_TRUE(model_.properties.empty());
  EXPECT_EQ(messages(), "");
}

TEST_F(Nastran, ShellsOfThePlaneHaveThicknessAndBarsAreEdges) {
  ASSERT_TRUE(import(square + "CBAR,20,9,1,2\nPSHELL,5,2,2.5\nMAT1,2,70000.,,.33\n")) << messages();
  ASSERT_EQ(model_.properties.size(), 1U);
  EXPECT_EQ(model_.properties[0].state, model::StressState::plane_stress);
  EXPECT_EQ(model_.properties[0].thickness, 2.5);
  EXPECT_EQ(test::faces(model_.mesh, "S9").faces,
            (std::vector<model::Face>{{base::ElementId(std::size_t{0}), 0}}));
  EXPECT_NE(messages().find("W336 a.bdf:5: CQUAD4 of 4 nodes"), std::string::npos) << messages();
  ASSERT_TRUE(import(square + "PSHELL,5,2,2.5,-1\nMAT1,2,70000.,,.33\n")) << messages();
  EXPECT_EQ(model_.properties[0].state, model::StressState::plane_strain);
  EXPECT_FALSE(import(square + "CBAR,20,9,1,2\nPBAR,9,2,1.,1.,1.,1.\n"));
  EXPECT_NE(messages().find("CBAR is not imported (1 entry) = there are no bars"),
            std::string::npos)
      << messages();
}

TEST_F(Nastran, ShellsOnSolidsAreSurfacesAndOthersAreRefused) {
  ASSERT_TRUE(import(tetrahedron + "CTRIA3,20,8,1,2,3\nPSHELL,8,1,1.-6\nMAT1,1,1.,,.3\n"))
      << messages();
  EXPECT_EQ(test::faces(model_.mesh, "S8").faces,
            (std::vector<model::Face>{{base::ElementId(std::size_t{0}), 0}}));
  EXPECT_NE(messages().find("left out: CTRIA3 of property 8"), std::string::npos) << messages();
  const std::string stray =
      tetrahedron + "GRID,5,,9.,0.,0.\nCTRIA3,20,8,1,2,5\nCTRIA3,21,8,1,3,5\n";
  EXPECT_FALSE(import(stray));
  EXPECT_NE(messages().find("a.bdf:7: 2 CTRIA3 of property 8 lie on no side of a solid"),
            std::string::npos)
      << messages();
  skip_ = mesh::InpSkip::all;
  EXPECT_TRUE(import(stray)) << messages();
  EXPECT_NE(messages().find("W467"), std::string::npos) << messages();
}

TEST_F(Nastran, PropertiesAreSetsByNumberAndByTheNamesOfPreprocessors) {
  const std::vector<std::pair<std::string, std::string>> comments{
      {"$HMNAME PROP             5\"lug body\" 5\nPSOLID,5,2\n", "LUG_BODY"},
      {"$ANSA_NAME_COMMENT;5;PSOLID;Lug;;NO;NO;\nPSOLID,5,2\n", "LUG"},
      {"$ Femap with NX Nastran Property 5 : the lug\nPSOLID,5,2\n", "THE_LUG"},
      {"$ Elements and Element Properties for region : lug.1\nPSOLID,5,2\n", "LUG_1"},
      {"$* Property: LUG 2\n$* \nPSOLID,5,2\n", "LUG_2"}};
  for (const auto& [text, name] : comments) {
    ASSERT_TRUE(import(tetrahedron + "MAT1,2,1.,,.3\n" + text)) << messages();
    EXPECT_EQ(elements("P5"), 1U) << text;
    EXPECT_EQ(elements(name), 1U) << text;
  }
  renames_ = {{"P5", "EYE"}};
  ASSERT_TRUE(import(tetrahedron)) << messages();
  EXPECT_EQ(elements("EYE"), 1U);
}

TEST_F(Nastran, ListsOfNumbersAreSets) {
  ASSERT_TRUE(import(tetrahedron + "CTRIA3,20,8,1,2,3\nSET3,4,GRID,1,THRU,3\nSET3,5,ELEM,10\n"
                                   "$HMSET        6        2 \"bore side\" 18\n"
                                   "SET     6       ELEM    LIST\n+       20\n"))
      << messages();
  EXPECT_EQ(labels("SET4"), (std::vector<base::Label>{1, 2, 3}));
  EXPECT_EQ(elements("SET5"), 1U);
  EXPECT_EQ(test::faces(model_.mesh, "BORE_SIDE").faces,
            (std::vector<model::Face>{{base::ElementId(std::size_t{0}), 0}}));
  // a list has its number where its name is taken
  ASSERT_TRUE(import(tetrahedron + "$HMNAME PROP 5\"lug\"\n$HMSET 6 2 \"lug\"\nSET3,6,ELEM,10\n"));
  EXPECT_EQ(elements("LUG") + elements("SET6"), 2U);
}

TEST_F(Nastran, ListsOfOtherThingsAreNone) {
  ASSERT_TRUE(import(tetrahedron + "SET3,7,PROP,1\nSET1,8,1,2\n")) << messages();
  EXPECT_EQ(model_.mesh.node_sets.size() + model_.mesh.element_sets.size() +
                model_.mesh.face_sets.size(),
            1U); // P5
}

TEST_F(Nastran, SupportsAndLoadsAreSetsWhereTheyArePassedOver) {
  const std::string loads = "SPC1,1,123,1,THRU,3\nSPC1,1,456,4\nSPC,2,4,3,0.\nSPCADD,9,1,2\n"
                            "FORCE,7,4,,1.,0.,0.,1.\nPLOAD4,8,10,5.,,,,1,4\nGRAV,6,,9.81,0.,0.,1.\n"
                            "LOAD,10,1.,1.,7\n";
  EXPECT_FALSE(import(tetrahedron + loads));
  EXPECT_NE(messages().find("E336 a.bdf:6: supports and loads are not imported: FORCE (1), GRAV "
                            "(1), LOAD (1), PLOAD4 (1), SPC (1), SPC1 (2), SPCADD (1)"),
            std::string::npos)
      << messages();
  EXPECT_EQ(diagnostics_.messages().size(), 1U) << messages();
  skip_ = mesh::InpSkip::loads;
  ASSERT_TRUE(import(tetrahedron + loads)) << messages();
  EXPECT_EQ(labels("SPC1_123"), (std::vector<base::Label>{1, 2, 3}));
  EXPECT_EQ(labels("SPC9_123"), (std::vector<base::Label>{1, 2, 3}));
  EXPECT_EQ(labels("SPC9_3"), (std::vector<base::Label>{4}));
  EXPECT_EQ(labels("FORCE_7"), (std::vector<base::Label>{4}));
  EXPECT_TRUE(labels("SPC1_456").empty()); // solids do not turn
  // node 4 is off the loaded side
  EXPECT_EQ(test::faces(model_.mesh, "PLOAD4_8").faces,
            (std::vector<model::Face>{{base::ElementId(std::size_t{0}), 0}}));
  EXPECT_NE(messages().find("where they act are the sets PLOAD4_8, FORCE_7, SPC1_123"),
            std::string::npos)
      << messages();
  ASSERT_TRUE(import(tetrahedron + loads + "GRDSET,,,,,,3\n")) << messages();
  EXPECT_NE(messages().find("directions of their own (CD)"), std::string::npos) << messages();
  skip_ = mesh::InpSkip::nothing;
  EXPECT_FALSE(import(tetrahedron + "GRID,5,,0.,0.,0.,,123\n"));
  EXPECT_NE(messages().find("PS of GRID (1)"), std::string::npos) << messages();
}

TEST_F(Nastran, PressuresActOnTheSidesThatTheirCornersName) {
  skip_ = mesh::InpSkip::loads;
  const auto side = [&](const test::NastranSample& sample, const std::string& corners) {
    std::string text = text_of(sample, test::NastranFieldFormat::free, false);
    text.insert(text.find("ENDDATA"), "PLOAD4,8,7,5.,,,," + corners + "\n");
    EXPECT_TRUE(import(text)) << messages();
    return test::faces(model_.mesh, "PLOAD4_8").faces.at(0).side + 1;
  };
  EXPECT_EQ(side(samples[0], "1,6"), 3); // S3 of a hexahedron is 1265
  EXPECT_EQ(side(samples[0], "7,5"), 2);
  EXPECT_EQ(side(samples[1], "1"), 1); // a triangle by one corner
  EXPECT_EQ(side(samples[1], "5"), 2);
  EXPECT_EQ(side(samples[1], "4,3"), 5);
  EXPECT_EQ(side(samples[2], "2,1"), 3); // of a tetrahedron the side off node 1
}

TEST_F(Nastran, WhatIsNotReadIsToldOnceForEachKind) {
  const std::string more = "RBE2,50,1,123,2,3\nRBE2,51,1,123,4\nCBUSH,52,9,1,2\nPBUSH,9,K,1.+5\n"
                           "MAT8,3,1.,1.,.3,1.\nEIGRL,1\nPARAM,POST,-1\nZZZ,1\n";
  EXPECT_FALSE(import(tetrahedron + more));
  EXPECT_EQ(diagnostics_.messages().size(), 4U) << messages();
  EXPECT_NE(messages().find("a.bdf:6: RBE2 is not imported (2 entries) = ties are $MPC"),
            std::string::npos)
      << messages();
  EXPECT_NE(messages().find("'ZZZ' is not imported"), std::string::npos) << messages();
  EXPECT_EQ(model_.mesh.element_count(), 0U);
  skip_ = mesh::InpSkip::all;
  ASSERT_TRUE(import(tetrahedron + more)) << messages();
  EXPECT_NE(messages().find("SKIP=ALL asks for: CBUSH (1), MAT8 (1), RBE2 (2), ZZZ (1)"),
            std::string::npos)
      << messages();
}

} // namespace
} // namespace spricka::test_nastran_model
