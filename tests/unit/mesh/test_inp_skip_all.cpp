// SPDX-License-Identifier: GPL-3.0-or-later
#include "inp_file.hpp"
#include "meshes.hpp"

#include <gtest/gtest.h>

#include <chrono>

namespace spricka::test_inp_skip_all {
namespace {

using Labels = std::vector<base::Label>;
using test::two_quads;

/// Input files as they are found, with cards that are no mesh.
class InpAsItIs : public test::InpFile {
protected:
  InpAsItIs() { skip_ = mesh::InpSkip::all; }
  bool import_strictly(const std::string& text) {
    skip_ = mesh::InpSkip::nothing;
    const bool sound = import(text);
    skip_ = mesh::InpSkip::all;
    return sound;
  }
  [[nodiscard]] bool says(const std::string& words) const {
    return messages().find(words) != std::string::npos;
  }
};

// Hexahedra 1 (LEFT) and 2 (RIGHT), 0 <= x <= 2, that share a face; thirteen lines of nodes.
const std::string nodes_of_hexahedra = R"(*NODE
1, 0, 0, 0
2, 1, 0, 0
3, 2, 0, 0
4, 0, 1, 0
5, 1, 1, 0
6, 2, 1, 0
7, 0, 0, 1
8, 1, 0, 1
9, 2, 0, 1
10, 0, 1, 1
11, 1, 1, 1
12, 2, 1, 1
)";
const std::string hexahedra = nodes_of_hexahedra + R"(*ELEMENT, TYPE=C3D8, ELSET=LEFT
1, 1, 2, 5, 4, 7, 8, 11, 10
*ELEMENT, TYPE=C3D8, ELSET=RIGHT
2, 2, 3, 6, 5, 8, 9, 12, 11
)";

TEST_F(InpAsItIs, EmptyFieldsAndDownwardRanges) {
  ASSERT_TRUE(import_strictly("*NODE\n1, 0., 0.\n2, 1., 0.\n3, , 1.\n4, 1., 1., , 0.\n"
                              "*ELEMENT, TYPE=CPE4, ELSET=E\n7, 1, 2, 4,,\n 3,,\n"
                              "*NSET, NSET=BACK, GENERATE\n4, 1, -3\n"
                              "*NSET, NSET=DOWN, GENERATE\n 3, 1\n*NSET, NSET=GAPS\n 2,, 1,\n"))
      << messages();
  EXPECT_EQ(labels("BACK"), (Labels{4, 1}));
  EXPECT_EQ(labels("DOWN"), (Labels{3, 2, 1}));
  EXPECT_EQ(labels("GAPS"), (Labels{2, 1}));
  EXPECT_EQ(model_.mesh.x[2], base::Vec3(0.0, 1.0, 0.0));
  EXPECT_NEAR(test::area(model_.mesh), 1.0, 1e-15);
  EXPECT_EQ(messages(),
            "W469 a.inp:5: a double comma in a line of *NODE counts as one: node 4 lies at (1, 1, "
            "0) = \n");
  EXPECT_FALSE(import_strictly(two_quads + "*NSET, NSET=N, GENERATE\n 5, 1, 2\n"));
}

TEST_F(InpAsItIs, RangesFarBeyondTheNodesCostNothing) {
  const std::string far = two_quads + "*NSET, NSET=FAR, GENERATE\n 1, 100000000000000000, 2\n"
                                      "*NSET, NSET=BACK, GENERATE\n 100000000000, 2, -2\n";
  const auto start = std::chrono::steady_clock::now();
  ASSERT_TRUE(import(far)) << messages();
  EXPECT_EQ(labels("FAR"), (Labels{1, 3, 5}));
  EXPECT_EQ(labels("BACK"), (Labels{6, 4, 2}));
  EXPECT_TRUE(says("W469 a.inp:18: 2 of the sets name what is not there, which is left out: FAR "
                   "has node 7"))
      << messages();
  EXPECT_FALSE(import_strictly(far));
  EXPECT_TRUE(says("set FAR has node 7, which is not there")) << messages();
  EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(1));
}

std::string steel(const std::string& lines) {
  return two_quads + "*ELSET, ELSET=EALL\n LEFT HALF, RIGHT\n*MATERIAL, NAME=STEEL\n" + lines +
         "*SOLID SECTION, ELSET=EALL, MATERIAL=STEEL\n";
}

TEST_F(InpAsItIs, OneRowOfATableIsConstant) {
  ASSERT_TRUE(import_strictly(steel("*ELASTIC\n210000., 0.3, 293.\n*DENSITY\n7.8e-9, 293.\n"
                                    "*EXPANSION, ZERO=293.\n1.2e-5, 293.\n")))
      << messages();
  EXPECT_EQ(model_.materials.at(0).E, 210000.0);
  EXPECT_EQ(model_.materials[0].nu, 0.3);
  EXPECT_EQ(model_.materials[0].alpha, 1.2e-5);
  const std::string twice = steel("*ELASTIC\n2.1e5, 0.3, 20.\n2.1e5, 0.3, 400.\n");
  EXPECT_TRUE(import_strictly(twice)) << messages();
  const std::string softer = steel("*ELASTIC\n2.1e5, 0.3, 20.\n1.7e5, 0.3, 400.\n");
  EXPECT_FALSE(import_strictly(softer));
  EXPECT_TRUE(says("*ELASTIC of STEEL has 2 rows of different values")) << messages();
  ASSERT_TRUE(import(softer));
  EXPECT_EQ(model_.materials.at(0).E, 2.1e5);
  EXPECT_TRUE(says("W469 a.inp:22: *ELASTIC of STEEL has 2 rows of different values: the first one "
                   "is taken, that at 20 degrees"))
      << messages();
}

TEST_F(InpAsItIs, WhatIsNotElasticIsLeftOutWithItsSections) {
  const std::string ortho =
      steel("*ELASTIC, TYPE=ORTHO\n1.,1.,1.,1.,1.,1.,1.,1.,\n1.\n*CONDUCTIVITY\n50.\n");
  EXPECT_FALSE(import_strictly(ortho));
  ASSERT_TRUE(import(ortho)) << messages();
  EXPECT_TRUE(model_.materials.empty());
  EXPECT_FALSE(model_.mesh.property[0].valid());
  EXPECT_TRUE(says("sections of material STEEL are left out, as it has no isotropic *ELASTIC: give "
                   "$MATERIAL and $PROPERTY for EALL"));
  EXPECT_TRUE(says("W468 a.inp: left out, though the model is another one without: *ELASTIC "
                   "TYPE=ORTHO (1, line 21)"))
      << messages();
}

TEST_F(InpAsItIs, EachKindOfCardIsListedOnce) {
  const std::string cards =
      "*SURFACE INTERACTION, NAME=I\n*SURFACE BEHAVIOR, PRESSURE-OVERCLOSURE=LINEAR\n 1e7\n"
      "*FRICTION\n 0.2, 1e6\n*TIE, NAME=T\n A, B\n*TIE, NAME=U\n C, D\n*RIGID BODY, NSET=ALL\n"
      "*TRANSFORM, NSET=ALL\n 1,0,0,0,1,0\n*COUPLING, SURFACE=A\n*KINEMATIC\n 1, 3\n"
      "*PHYSICAL CONSTANTS, ABSOLUTE ZERO=-273\n*AMPLITUDE, NAME=A\n 0,0,1,1\n"
      "*STEP\n*STATIC\n*CLOAD\n 3, 1, 5.\n*PLASTIC\n*EL FILE\n S\n*END STEP\n"
      "*SOLID SECTION, ELSET=RIGHT, MATERIAL=M, ORIENTATION=O\n*MATERIAL, NAME=M\n*ELASTIC\n1,0\n"
      "*PLASTIC\n 1., 0.\n*PLASTIC\n 1., 0.\n";
  ASSERT_TRUE(import(two_quads + cards)) << messages();
  const auto& all = diagnostics_.messages();
  ASSERT_EQ(all.size(), 3U) << messages(); // and CPS4R
  EXPECT_EQ(all[0].text,
            "a.inp: passed over, as SKIP=ALL asks for: *AMPLITUDE (1, line 34), *CLOAD (1, line "
            "38), *FRICTION (1, line 21), *PHYSICAL CONSTANTS (1, line 33), *SOLID SECTION "
            "ORIENTATION (1, line 44), *STATIC (1, line 37), *STEP (1, line 36), *SURFACE BEHAVIOR "
            "(1, line 19), *SURFACE INTERACTION (1, line 18)");
  EXPECT_EQ(all[1].text,
            "a.inp: left out, though the model is another one without: *COUPLING (1, line 30), "
            "*KINEMATIC (1, line 31), *PLASTIC (3, line 40), *RIGID BODY (1, line 27), *TIE (2, "
            "line 23), *TRANSFORM (1, line 28)");
}

TEST_F(InpAsItIs, ContactSupportsAndLoadsAreKeptForTheCards) {
  ASSERT_TRUE(import(
      hexahedra +
      "*SURFACE INTERACTION, NAME=I\n*SURFACE BEHAVIOR, PRESSURE-OVERCLOSURE=TIED\n 1e7\n"
      "*FRICTION\n 0.2, 1e6\n*CONTACT PAIR, INTERACTION=I, TYPE=SURFACE TO SURFACE, ADJUST=0.5\n"
      " A, B\n C, D\n*BOUNDARY\n 3, 2\nALL, ENCASTRE\n*STEP, NLGEOM\n*STATIC\n*BOUNDARY, OP=NEW\n"
      " ALL, 1, 6, 0.\n*DLOAD\n LEFT, P2, 5.\n LEFT, GRAV, 9810., 0., 0., -2.\n 2, P2, 7.\n"
      "*END STEP\n"))
      << messages();
  const mesh::InpJointCards& joint = physics_.joint;
  ASSERT_EQ(joint.pairs.size(), 2U);
  EXPECT_EQ(joint.pairs[1].slave, "C");
  EXPECT_EQ(joint.pairs[1].adjust, 0.5);
  EXPECT_TRUE(joint.interactions.at(0).tied);
  EXPECT_EQ(joint.interactions[0].friction, 0.2);
  ASSERT_EQ(joint.steps.size(), 2U);
  ASSERT_EQ(joint.steps[0].displacements.size(), 4U);
  EXPECT_EQ(joint.steps[0].displacements[0].of.node, 3);
  EXPECT_EQ(joint.steps[0].displacements[0].dof, 1);
  EXPECT_TRUE(joint.steps[1].new_supports);
  EXPECT_TRUE(joint.steps[1].large_displacements);
  EXPECT_EQ(joint.steps[1].displacements.size(), 3U); // rotations of solids are none
  ASSERT_EQ(joint.steps[1].loads.size(), 3U);
  EXPECT_EQ(joint.steps[1].loads[1].value, base::Vec3(0.0, 0.0, -9810.0));
  // a deck needs a name for what a pressure acts on
  EXPECT_EQ(test::faces(model_.mesh, "LEFT_P2").faces,
            (std::vector<model::Face>{{base::ElementId(std::size_t{0}), 1}}));
  EXPECT_EQ(test::faces(model_.mesh, "DLOAD_1").faces,
            (std::vector<model::Face>{{base::ElementId(std::size_t{1}), 1}}));
}

// As gmsh writes a solid: its curves are bars, its surfaces plane elements.
TEST_F(InpAsItIs, ElementsOnFacesOfSolidsAreSurfaces) {
  const std::string gmsh = nodes_of_hexahedra +
                           "*ELEMENT, type=T3D2, ELSET=Line1\n 21, 1, 2\n"
                           "*ELEMENT, type=CPS4, ELSET=Surface1\n 31, 1, 4, 10, 7\n"
                           "*ELEMENT, type=CPS4, ELSET=Between\n 32, 2, 8, 11, 5\n"
                           "*ELEMENT, type=C3D8, ELSET=Volume1\n 1, 1, 2, 5, 4, 7, 8, 11, 10\n"
                           " 2, 2, 3, 6, 5, 8, 9, 12, 11\n*ELSET, ELSET=END\n 31\n"
                           "*ELSET, ELSET=BODY\n 1, 2\n*SURFACE, NAME=SIDE\n END, SPOS\n";
  ASSERT_TRUE(import_strictly(gmsh)) << messages();
  EXPECT_EQ(model_.mesh.dim, 3);
  EXPECT_EQ(elements("BODY").elements.size(), 2U);
  const model::Face end{base::ElementId(std::size_t{0}), 5}; // S6: 4 1 5 8
  for (const char* name : {"SURFACE1", "END", "SIDE"}) {
    EXPECT_EQ(test::faces(model_.mesh, name).faces, std::vector<model::Face>{end}) << name;
  }
  EXPECT_EQ(test::faces(model_.mesh, "BETWEEN").faces.size(), 1U);
  EXPECT_TRUE(says("W466 a.inp:14: 1 elements of type T3D2 lie on no side of others"))
      << messages();
  EXPECT_TRUE(says("sets are taken as surfaces: 2 CPS4 =")) << messages();
  EXPECT_FALSE(import(gmsh + "*ELEMENT, TYPE=S3, ELSET=SHELL\n 41, 1, 2, 3\n 42, 1, 2, 4\n"));
  EXPECT_EQ(messages(),
            "E336 a.inp:29: 2 of 2 elements of type S3 are no face of a solid: shells and "
            "membranes are not imported = \n");
  const std::string inside = "*ELEMENT, type=CPS3, ELSET=IN\n 51, 1, 5, 9\n";
  EXPECT_FALSE(import_strictly(gmsh + inside));
  EXPECT_TRUE(import(gmsh + inside)) << messages();
  EXPECT_TRUE(says("1 elements of type CPS3 lie on no side of others")) << messages();
}

TEST_F(InpAsItIs, ASetWithoutAFaceMeansItsFreeFaces) {
  ASSERT_TRUE(import_strictly(hexahedra + "*SURFACE, NAME=S\n LEFT,\n*SURFACE, NAME=ALL\n"
                                          " LEFT\n RIGHT\n*SURFACE, NAME=ONE\n 2\n"))
      << messages();
  EXPECT_EQ(test::faces(model_.mesh, "S").faces.size(), 5U);
  EXPECT_EQ(test::faces(model_.mesh, "ALL").faces.size(), 10U);
  EXPECT_EQ(test::faces(model_.mesh, "ONE").faces.size(), 5U);
}

TEST_F(InpAsItIs, OneSetOfElementsCanBeTakenAlone) {
  element_set_ = "right";
  const std::string text =
      hexahedra + "*NSET, NSET=ALL, GENERATE\n 1, 12\n*NSET, NSET=FOOT\n 1, 4\n"
                  "*NSET, NSET=OF, ELSET=LEFT\n*SURFACE, NAME=TOP\n LEFT, S2\n RIGHT, S2\n"
                  "*SURFACE, NAME=ENDS\n 1, S6\n*MATERIAL, NAME=A\n*ELASTIC\n 1., 0.\n"
                  "*MATERIAL, NAME=B\n*ELASTIC\n 2., 0.\n*SOLID SECTION, ELSET=LEFT, MATERIAL=A\n"
                  "*SOLID SECTION, ELSET=RIGHT, MATERIAL=B\n";
  ASSERT_TRUE(import(text)) << messages();
  EXPECT_EQ(model_.mesh.element_label, Labels{2});
  EXPECT_EQ(labels("ALL"), (Labels{2, 3, 5, 6, 8, 9, 11, 12}));
  EXPECT_EQ(model_.mesh.node_sets.size(), 1U); // nothing of FOOT and OF is in it
  EXPECT_EQ(model_.mesh.face_sets.size(), 1U);
  EXPECT_EQ(test::faces(model_.mesh, "TOP").faces.size(), 1U);
  ASSERT_EQ(model_.materials.size(), 1U);
  EXPECT_EQ(model_.materials[0].name, "B");
  EXPECT_EQ(messages(), "");
  element_set_ = "RIHGT";
  EXPECT_FALSE(import(text));
  EXPECT_TRUE(says("there is no element set 'RIHGT' = did you mean 'RIGHT'")) << messages();
  element_set_.clear();
  ASSERT_TRUE(import(text));
  EXPECT_EQ(labels("OF"), (Labels{1, 2, 5, 4, 7, 8, 11, 10}));
}

TEST_F(InpAsItIs, WhatJoinsPointsIsLeftOutWithAWord) {
  const std::string springs = two_quads + "*ELEMENT, TYPE=SPRINGA, ELSET=SP\n 51, 1, 6\n"
                                          "*SPRING, ELSET=SP\n\n 5.\n*ELSET, ELSET=E\n 10, 51\n";
  EXPECT_FALSE(import_strictly(springs));
  EXPECT_TRUE(says("elements of type SPRINGA are not known (1 lines)")) << messages();
  ASSERT_TRUE(import(springs)) << messages();
  EXPECT_EQ(elements("E").elements.size(), 1U);
  EXPECT_TRUE(says("*SPRING (1, line 20), elements SPRINGA (1, line 18)")) << messages();
}

TEST_F(InpAsItIs, OneMessageForOneCause) {
  EXPECT_FALSE(import("*NODE\n 1, x\n 2, y\n 3, z\n*ELEMENT, TYPE=B31\n 1, 1, 2\n 2, 2, 3\n"
                      "*ELEMENT, TYPE=B31\n 3, 1, 3\n"));
  EXPECT_EQ(diagnostics_.messages().size(), 2U) << messages();
  EXPECT_TRUE(says("a.inp:2: a line of *NODE is number, x, y, z (and 2 more)")) << messages();
  EXPECT_TRUE(says("a.inp:5: elements of type B31 are not known (3 lines)")) << messages();
}

TEST_F(InpAsItIs, OfTwoSectionsTheLaterCounts) {
  const std::string text =
      hexahedra + "*ELSET, ELSET=BOTH\n 1, 2\n*MATERIAL, NAME=A\n*ELASTIC\n 1., 0.\n"
                  "*MATERIAL, NAME=B\n*ELASTIC\n 2., 0.\n*SOLID SECTION, ELSET=BOTH, MATERIAL=A\n"
                  "*SOLID SECTION, ELSET=RIGHT, MATERIAL=B\n";
  EXPECT_FALSE(import_strictly(text));
  ASSERT_TRUE(import(text)) << messages();
  const base::PropertyId property = model_.mesh.property[1];
  EXPECT_EQ(model_.materials[model_.properties[property.index()].material.index()].name, "B");
  EXPECT_TRUE(says("element 2 has a *SOLID SECTION already: of two the later one counts"));
}

} // namespace
} // namespace spricka::test_inp_skip_all
