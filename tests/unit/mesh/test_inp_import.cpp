// SPDX-License-Identifier: GPL-3.0-or-later
#include "distorted.hpp"
#include "inp_file.hpp"
#include "mesh/export/write_inp.hpp"
#include "mesh/quality.hpp"
#include "meshes.hpp"
#include "model/model.hpp"

#include <gtest/gtest.h>

namespace spricka::test_inp_import {
namespace {

namespace fs = std::filesystem;
using Inp = test::InpFile;
using test::two_quads;

TEST_F(Inp, EveryTypeComesBackBitForBit) {
  for (const base::ElementType type : test::all_types) {
    model::Model wanted;
    wanted.mesh = test::distorted_block(type);
    if (!mesh::types_without_inp_name(wanted.mesh).empty()) {
      EXPECT_TRUE(type == base::ElementType::quamc9 || type == base::ElementType::hexec27);
      continue;
    }
    SCOPED_TRACE(base::element_info(type).name);
    ASSERT_TRUE(import(mesh::write_inp(wanted, nullptr))) << messages();
    EXPECT_EQ(messages(), "");
    const model::Mesh& found = model_.mesh;
    EXPECT_EQ(found.dim, base::element_info(type).dim);
    EXPECT_EQ(found.x, wanted.mesh.x);
    EXPECT_EQ(found.node_label, wanted.mesh.node_label);
    EXPECT_EQ(found.type, wanted.mesh.type);
    EXPECT_EQ(found.nodes, wanted.mesh.nodes);
    EXPECT_NEAR(test::area(found), test::area(wanted.mesh), 1e-15);
    for (const model::ElementSet& set : wanted.mesh.element_sets) {
      EXPECT_EQ(elements(set.name).elements, set.elements);
    }
    for (const model::FaceSet& set : wanted.mesh.face_sets) {
      EXPECT_EQ(test::faces(found, set.name).faces, set.faces);
    }
    EXPECT_EQ(nodes("LINE").nodes, wanted.mesh.node_sets[0].nodes);
  }
}

TEST_F(Inp, FreeFormCommentsContinuationAndStrayNodes) {
  ASSERT_TRUE(import(two_quads)) << messages();
  EXPECT_EQ(model_.mesh.node_count(), 6U);
  EXPECT_NEAR(test::area(model_.mesh), 2.0, 1e-15);
  EXPECT_EQ(labels("ALL"), (std::vector<base::Label>{1, 2, 3, 4, 5, 6})); // 99 has no element
  EXPECT_EQ(elements("LEFT_HALF").elements.size(), 1U);
  EXPECT_EQ(model_.mesh.element_label, (std::vector<base::Label>{10, 20}));
  // reduced integration is said
  EXPECT_NE(messages().find("W336 a.inp:12: CPS4R"), std::string::npos) << messages();
}

TEST_F(Inp, SetsByRangeByNameAndInTheirOrder) {
  ASSERT_TRUE(import(two_quads + "*NSET, NSET=ODD, GENERATE\n 1, 5, 2\n"
                                 "*NSET, NSET=PATH, UNSORTED\n 6, 5\n 4\n"
                                 "*Nset, Nset=both\n odd, 2,\n PATH\n"
                                 "*ELSET, ELSET=EALL\n left half, RIGHT\n"
                                 "*SURFACE, NAME=TOP\n EALL, S3\n 10, S4\n"
                                 "*SURFACE, NAME=SLAVE, TYPE=NODE\n ODD, 1.\n 6\n"))
      << messages();
  EXPECT_EQ(labels("PATH"), (std::vector<base::Label>{6, 5, 4}));
  EXPECT_EQ(labels("BOTH"), (std::vector<base::Label>{1, 3, 5, 2, 6, 4}));
  EXPECT_EQ(labels("SLAVE"), (std::vector<base::Label>{1, 3, 5, 6}));
  EXPECT_EQ(elements("EALL").elements.size(), 2U);
  const base::ElementId left(std::size_t{0});
  const base::ElementId right(std::size_t{1});
  EXPECT_EQ(test::faces(model_.mesh, "TOP").faces,
            (std::vector<model::Face>{{left, 2}, {right, 2}, {left, 3}}));
}

const std::string steel = "*MATERIAL, NAME=Steel-1\n*ELASTIC\n 210000, 0.3\n*DENSITY\n 7.85E-9,\n"
                          "*EXPANSION, TYPE=ISO\n 1.2e-5\n"
                          "*SOLID SECTION, ELSET=EALL, MATERIAL=steel-1\n 2.5\n";

TEST_F(Inp, MaterialsAndSectionsBecomeProperties) {
  scale_ = 10.0;
  renames_ = {{"right", "STARBOARD"}};
  ASSERT_TRUE(import(two_quads + "*ELSET, ELSET=EALL\n LEFT HALF, RIGHT\n" + steel, "PLATE."))
      << messages();
  ASSERT_EQ(model_.materials.size(), 1U);
  EXPECT_EQ(model_.materials[0].name, "PLATE.STEEL_1");
  EXPECT_EQ(model_.materials[0].E, 210000.0);
  EXPECT_EQ(model_.materials[0].alpha, 1.2e-5);
  ASSERT_EQ(model_.properties.size(), 1U);
  EXPECT_EQ(model_.properties[0].thickness, 25.0);
  EXPECT_EQ(model_.properties[0].state, model::StressState::plane_stress);
  EXPECT_TRUE(model_.mesh.property[1].valid());
  EXPECT_EQ(elements("PLATE.STARBOARD").elements.size(), 1U);
  EXPECT_NE(messages().find("W337"), std::string::npos);
}

TEST_F(Inp, OnePartUsedOnceIsRead) {
  ASSERT_TRUE(import("*Part, name=P\n" + two_quads +
                     "*End Part\n*Assembly, name=A\n*Instance, name=P-1, part=P\n*End Instance\n"
                     "*Nset, nset=TIP, instance=P-1\n 3,\n*Elset, elset=E, internal\n P-1.RIGHT\n"
                     "*End Assembly\n"))
      << messages();
  EXPECT_EQ(labels("TIP"), (std::vector<base::Label>{3}));
  EXPECT_EQ(elements("E").elements.size(), 1U);
  EXPECT_FALSE(import("*Part, name=P\n" + two_quads +
                      "*End Part\n*Assembly, name=A\n*Instance, name=P-1, part=P\n 1., 0., 0.\n"
                      "*End Instance\n*Instance, name=P-2, part=P\n*End Instance\n"
                      "*Node\n 7, 0, 0, 0\n*End Assembly\n"));
  EXPECT_NE(messages().find("moved or turned"), std::string::npos) << messages();
  EXPECT_NE(messages().find("second *INSTANCE"), std::string::npos);
  EXPECT_NE(messages().find("*NODE in an *ASSEMBLY"), std::string::npos);
}

TEST_F(Inp, IncludesCountFromTheIncludingFileAndMayNotLoop) {
  fs::create_directories(folder_ / "sub");
  write("sub/mesh.inc", two_quads + "*INCLUDE, INPUT=sets.inc\n");
  write("sub/sets.inc", "*ELSET, ELSET=EALL\n 10, 20\n");
  ASSERT_TRUE(import("*INCLUDE, INPUT=sub/mesh.inc\n" + steel)) << messages();
  EXPECT_EQ(elements("EALL").elements.size(), 2U);
  write("sub/sets.inc", "*INCLUDE, INPUT=mesh.inc\n");
  EXPECT_FALSE(import("*INCLUDE, INPUT=sub/mesh.inc\n*INCLUDE, INPUT=gone.inc\n"));
  EXPECT_NE(messages().find("sets.inc:1: *INCLUDE"), std::string::npos) << messages();
  EXPECT_NE(messages().find("a.inp:2: there is no file"), std::string::npos);
}

// Somebody else's input may include any file that this user can read.
TEST_F(Inp, WordsOfAnIncludedFileAreNotRepeated) {
  write("secret", "password: 1234\n");
  EXPECT_FALSE(import(two_quads + "*NSET, NSET=N\n*INCLUDE, INPUT=secret\n"));
  EXPECT_NE(messages().find("secret:1: there is no set '..'"), std::string::npos) << messages();
  EXPECT_EQ(messages().find("1234"), std::string::npos) << messages();
  EXPECT_FALSE(import(two_quads + "*NSET, NSET=N\n gone\n"));
  EXPECT_NE(messages().find("there is no set 'gone'"), std::string::npos) << messages();
}

TEST_F(Inp, WhatChangesThePhysicsIsRefusedAllAtOnceWithItsPlace) {
  EXPECT_FALSE(import(two_quads + "*BOUNDARY\n 1, 1, 2\n*Orientation, name=O\n 1,0,0,0,1,0\n"
                                  "*TIE, NAME=T\n A, B\n*STEP\n*STATIC\n*CLOAD\n 3, 1, 5.\n"
                                  "*BOUNDARY\n 4, 1\n*NODE FILE\nU\n*END STEP\n"));
  const std::string all = messages();
  EXPECT_NE(all.find("E336 a.inp:18: *BOUNDARY is not imported (and 1 more) = supports are"),
            std::string::npos)
      << all;
  for (const char* word : {"*ORIENTATION", "*TIE", "*STEP", "*STATIC", "*CLOAD"}) {
    EXPECT_NE(all.find(word), std::string::npos) << word;
  }
  EXPECT_EQ(all.find("*NODE FILE"), std::string::npos);
  EXPECT_EQ(all.find("*END STEP"), std::string::npos);
  EXPECT_EQ(model_.mesh.node_count(), 0U);
  EXPECT_TRUE(model_.mesh.node_sets.empty());
}

TEST_F(Inp, EquationsTieFreedoms) {
  ASSERT_TRUE(import(two_quads + "*EQUATION\n 2\n 1, 1, 1., 3, 2, -2.\n"
                                 " 3\n 1, 2, 1.\n 2, 2, 1., 2, 2, -1.\n"))
      << messages();
  ASSERT_EQ(model_.mpcs.size(), 2U);
  const auto& first = std::get<model::ConstraintEquation>(model_.mpcs[0]);
  ASSERT_EQ(first.terms.size(), 2U);
  EXPECT_EQ(model_.mesh.node_label[first.terms[1].node.index()], 3);
  EXPECT_EQ(first.terms[1].dof, 1);
  EXPECT_EQ(first.terms[1].coefficient, -2.0);
  EXPECT_EQ(std::get<model::ConstraintEquation>(model_.mpcs[1]).terms.size(),
            1U); // those of node 2 cancel
}

TEST_F(Inp, MistakesNameTheirLine) {
  const std::vector<std::pair<std::string, std::string>> cases{
      {"*ELEMENT, TYPE=S4\n 30, 1,2,5,4\n",
       "a.inp:18: 1 of 1 elements of type S4 are no face of a solid"},
      {"*ELEMENT, TYPE=CPS3, OFFSET=1\n 30, 1,2,5\n", "a.inp:18: *ELEMENT: OFFSET is not"},
      {"*ELEMENT, TYPE=CPS3\n 30, 1,2\n", "a.inp:19: CPS3 takes 3 nodes; the element ends early"},
      {"*ELEMENT, TYPE=CPS3\n 30, 1,2,5,4\n", "a.inp:19: CPS3 takes 3 nodes"},
      {"*ELEMENT, TYPE=CPS3\n 30, 1,2,77\n", "a.inp:19: element 30 has node 77"},
      {"*ELEMENT, TYPE=CPS3\n 10, 1,2,5\n", "a.inp:19: element 10 is defined twice"},
      {"*NODE\n 5, 0., 0.\n", "node 5 is defined twice"},
      {"*NODE\n 8, x, 0.\n", "a.inp:19: a line of *NODE"},
      {"*NODE, SYSTEM=C\n 8, 1., 0.\n", "SYSTEM is not understood"},
      {"*NSET, NSET=N\n NOBODY\n", "a.inp:19: there is no set 'NOBODY'"},
      {"*NSET, NSET=N\n 77\n", "a.inp:18: set N has node 77"},
      {"*SURFACE, NAME=S\n RIGHT, S5\n", "a.inp:19: QUAM4 has no side S5"},
      {"*SURFACE, NAME=S\n RIGHT, T1\n", "a.inp:19: a line of *SURFACE"},
      {"*ELEMENT, TYPE=C3D4\n 30, 1,2,5,4\n",
       "2 of 2 elements of type CPS4 are no face of a solid"},
      {"*EQUATION\n 2\n 1, 1, 1.\n", "a.inp:19: the *EQUATION ends early"},
      {"*EQUATION\n 1\n ALL, 1, 1.\n", "a.inp:20: a term of an *EQUATION"},
      {"*EQUATION\n 1\n 99, 1, 1.\n", "a.inp:19: an *EQUATION names freedom 1 of node 99"},
      {"*ELASTIC\n 1., 0.3\n", "*ELASTIC without a *MATERIAL"},
      {"*MATERIAL, NAME=M\n*ELASTIC\n 1., 0.5\n", "Poisson"},
      {"*MATERIAL, NAME=M\n*ELASTIC\n 1., 0.3, 20.\n 2., 0.3, 90.\n", "temperature"},
      {"*MATERIAL, NAME=M\n*ELASTIC, TYPE=ORTHO\n 1., 0.3\n", "TYPE=ISO"},
      {"*MATERIAL, NAME=M\n", "material M has no *ELASTIC"},
      {"*SOLID SECTION, ELSET=RIGHT, MATERIAL=M\n", "there is no material M"},
      {"*MATERIAL, NAME=M\n*ELASTIC\n1.,0.3\n*SOLID SECTION, ELSET=R, MATERIAL=M\n",
       "there is no element set R"},
      {"*MATERIAL, NAME=M\n*ELASTIC\n1.,0.3\n*SOLID SECTION, ELSET=RIGHT, MATERIAL=M\n,\n"
       "*SOLID SECTION, ELSET=RIGHT, MATERIAL=M\n,\n",
       "element 20 has a *SOLID SECTION already"}};
  for (const auto& [text, words] : cases) {
    EXPECT_FALSE(import(two_quads + text)) << text;
    EXPECT_NE(messages().find(words), std::string::npos) << text << messages();
    EXPECT_EQ(model_.mesh.element_count(), 0U);
  }
  EXPECT_FALSE(import(""));
  EXPECT_NE(messages().find("no elements"), std::string::npos);
}

TEST_F(Inp, ElementsWithManyNodesGoOnOverLines) {
  model::Model block;
  block.mesh = test::distorted_block(base::ElementType::hexec20);
  const std::string text = mesh::write_inp(block, nullptr);
  EXPECT_NE(text.find(",\n"), std::string::npos);
  ASSERT_TRUE(import(text)) << messages();
  EXPECT_TRUE(mesh::find_invalid_elements(model_.mesh).empty());
}

} // namespace
} // namespace spricka::test_inp_import
