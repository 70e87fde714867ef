// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/import/nastran_card.hpp"
#include "mesh/import/recognise_mesh_file.hpp"
#include "mesh/quality.hpp"
#include "meshes.hpp"
#include "nastran_file.hpp"

#include <gtest/gtest.h>

#include <fmt/format.h>

#include <filesystem>
#include <fstream>
#include <random>

namespace spricka::test_nastran_import {
namespace {

using test::Nastran;
using test::samples;
using test::tetrahedron;
using test::text_of;
namespace fs = std::filesystem;

TEST_F(Nastran, NodesOfEveryElementLieOnTheirEdgesInEachFormat) {
  for (const test::NastranSample& sample : samples) {
    for (const bool middles : {false, true}) {
      for (const bool mirror : {false, true}) {
        SCOPED_TRACE(sample.name + (middles ? " middles" : "") + (mirror ? " mirrored" : ""));
        ASSERT_TRUE(import(text_of(sample, test::NastranFieldFormat::narrow, middles, mirror)))
            << messages();
        const model::Mesh small = model_.mesh;
        ASSERT_EQ(small.element_count(), 1U);
        const base::ElementType type = middles ? sample.quadratic : sample.linear;
        EXPECT_EQ(small.type[0], type);
        EXPECT_EQ(small.element_label[0], 7);
        EXPECT_TRUE(mesh::find_invalid_elements(small).empty());
        EXPECT_NEAR(test::area(small), sample.volume, 1e-14);
        const auto nodes = small.element_nodes(base::ElementId(std::size_t{0}));
        const base::ElementInfo& info = base::element_info(type);
        for (int m = 0; info.corners + m < info.nodes; ++m) {
          const auto [a, b] = shape::edge_corners(type, m);
          const auto x = [&](int i) { return small.x[nodes[static_cast<std::size_t>(i)].index()]; };
          EXPECT_LT((x(info.corners + m) - 0.5 * (x(a) + x(b))).norm(), 1e-15) << m;
        }
        for (const test::NastranFieldFormat format :
             {test::NastranFieldFormat::wide, test::NastranFieldFormat::free}) {
          ASSERT_TRUE(import(text_of(sample, format, middles, mirror))) << messages();
          EXPECT_EQ(model_.mesh.x, small.x);
          EXPECT_EQ(model_.mesh.nodes, small.nodes);
          EXPECT_EQ(model_.mesh.node_label, small.node_label);
        }
        EXPECT_EQ(elements("P3"), 1U);
      }
    }
  }
}

TEST(NastranNumbers, AreReadAsNastranWritesThem) {
  for (const auto& [text, value] : std::vector<std::pair<std::string, double>>{{"1.5", 1.5},
                                                                               {"+1.5", 1.5},
                                                                               {"-.5", -0.5},
                                                                               {"7.+5", 7e5},
                                                                               {"1.5-3", 1.5e-3},
                                                                               {"-1.5+3", -1500},
                                                                               {"1.5D-3", 1.5e-3},
                                                                               {"1.5E+3", 1500},
                                                                               {"1.5e3", 1500},
                                                                               {"3", 3.0}}) {
    EXPECT_EQ(mesh::parse_nastran_real(text), value) << text;
  }
  for (const char* text : {"", "+", "x", "1.2.3", "1.5-", "inf", "nan", "1 2", "1.e999", "0x1"}) {
    EXPECT_FALSE(mesh::parse_nastran_real(text)) << text;
  }
}

TEST_F(Nastran, LinesContinueInAllTheirForms) {
  const std::vector<std::string> forms{
      "CHEXA   1       1       1       2       3       4       5       6       +A\n"
      "+A      7       8\n",
      "chexa   1       1       1       2       3       4       5       6\n        7       8\n",
      "CHEXA\t1\t1\t1\t2\t3\t4\t5\t6\n+\t7\t8\n",
      "CHEXA   1       1       1       2       3       4       5       6       ABC\n$ between\n\n"
      "+BC     7       8       $ a remark\n",
      "CHEXA*  1               1               1               2               *A\n"
      "*A      3               4               5               6\n*       7               8\n",
      "CHEXA*  1               1               1               2\n"
      "*       3               4               5               6\n+       7       8\n",
      "CHEXA,1,1,1,2,3,4,5,6,+X\n+X,7,8\n",
      "CHEXA,1,1,1,2,3,4,5,6\n,7,8\n",
      "CHEXA , 1, 1, 1, 2, 3, 4, 5, 6, 7, 8\n",
      "CHEXA,1,1,1,2,3,4,5,6,+,7,8\n",
      "CHEXA*,1,1,1,2,*\n*,3,4,5,6\n*,7,8\n"};
  std::string grids;
  for (std::size_t i = 0; i < 8; ++i) {
    grids += grid(test::NastranFieldFormat::narrow, static_cast<int>(i) + 1, samples[0].corners[i]);
  }
  for (const std::string& form : forms) {
    ASSERT_TRUE(import(grids + form)) << form << messages();
    EXPECT_NEAR(test::area(model_.mesh), 2.0, 1e-14) << form;
  }
}

TEST_F(Nastran, PointsCountInCoordinateSystems) {
  // cylindrical about the line x = 1, y = 2, its zero angle along y; then one within it
  const std::string systems = "CORD2C,3,0,1.,2.,0.,1.,2.,1.\n,1.,3.,0.\n"
                              "CORD2R,4,3,1.,0.,0.,1.,0.,1.\n,2.,0.,0.\n"
                              "CORD2S,6,0,0.,0.,0.,0.,0.,1.\n,1.,0.,0.\n";
  ASSERT_TRUE(import("GRID,1,3,2.,0.,0.\nGRID,2,3,2.,90.,0.\nGRID,3,4,0.,0.,0.\nGRDSET,,6\n"
                     "GRID,4,,2.,90.,90.\nCTETRA,1,1,1,2,3,4\n" +
                     systems))
      << messages();
  const std::vector<base::Vec3> wanted{{1, 4, 0}, {-1, 2, 0}, {1, 3, 0}, {0, 2, 0}};
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_LT((model_.mesh.x[i] - wanted[i]).norm(), 1e-14) << i;
  }
  EXPECT_FALSE(import(tetrahedron + "GRID,5,7\nGRID,6,7\nGRID,7,8\nCORD1R,8,1,2,3\n"));
  EXPECT_NE(messages().find("a.bdf:6: the coordinate system 7 of a GRID is not there"),
            std::string::npos)
      << messages();
  EXPECT_NE(messages().find("system 8 of a GRID is a CORD1R"), std::string::npos) << messages();
  EXPECT_FALSE(import(tetrahedron + "GRID,5,7\nCORD2R,7,7,0.,0.,0.,0.,0.,1.\n,1.,0.,0.\n"));
  EXPECT_NE(messages().find("is defined by itself"), std::string::npos) << messages();
}

TEST_F(Nastran, IncludesAreFollowedAndTheirLinesAreNotRepeated) {
  fs::create_directories(folder_ / "sub");
  write("sub/grids.bdf", tetrahedron.substr(0, tetrahedron.find("CTETRA")));
  const std::string elements = tetrahedron.substr(tetrahedron.find("CTETRA"));
  ASSERT_TRUE(import("BEGIN BULK\nINCLUDE 'sub/\n  grids.bdf'\n" + elements)) << messages();
  EXPECT_EQ(model_.mesh.node_count(), 4U);
  write("secret", "password 1234\nMAT1,x5\n");
  EXPECT_FALSE(import(tetrahedron + "INCLUDE secret\nINCLUDE 'gone.bdf'\nINCLUDE \"a.bdf\"\n"));
  EXPECT_EQ(messages().find("PASSWORD"), std::string::npos) << messages();
  EXPECT_EQ(messages().find("x5"), std::string::npos) << messages();
  EXPECT_NE(messages().find("a.bdf:7: there is no file"), std::string::npos) << messages();
  EXPECT_NE(messages().find("a.bdf:8: INCLUDE: "), std::string::npos) << messages();
  write("secret", "password 1234\nlogin 5678\n");
  skip_ = mesh::InpSkip::all;
  EXPECT_TRUE(import(tetrahedron + "INCLUDE secret\nZZZ,1\n"));
  EXPECT_NE(messages().find("asks for: ZZZ (1), others in included files (2)"), std::string::npos)
      << messages();
}

TEST_F(Nastran, MistakesNameLineAndColumn) {
  const std::vector<std::pair<std::string, std::string>> cases{
      {"GRID    7               1.2.3   0.      0.\n",
       "a.bdf:6: GRID: X1 in column 25 is '1.2.3', which is no number"},
      {"GRID*   7                               1.              2.\n*       x\n",
       "a.bdf:7: GRID: X3 in column 9 is 'x', which is no number"},
      {"CTETRA,11,5,1,2,3\n", "a.bdf:6: CTETRA: a node is not given"},
      {"CTETRA,11,5,1,2,3,4.\n",
       "a.bdf:6: CTETRA: a node in column 19 is '4.', which is no positive"},
      {"CTETRA,11,5,1,2,3,77\n", "a.bdf:6: element 11 has node 77, which is not there"},
      {"CTETRA,10,5,1,2,3,4\n", "a.bdf:6: element 10 is defined twice"},
      {"GRID,3,,0.,0.,0.\n", "a.bdf:6: GRID 3 stands in line 3 already"},
      {"CTETRA  11      5       1       2       3       4                       +A\nGRID,9\n",
       "a.bdf:6: the line ends with '+A', and no line continues it"},
      {"CTETRA  11      5       1       2       3       4                       +A\n+B\n",
       "a.bdf:7: the line continues 'B', and the one before it is continued by 'A'"},
      {"CTETRA,11,5,1,2,3,4,5,6\n", "some of the nodes between corners are missing"},
      {"MAT1,1,1.\n", "a.bdf:6: MAT1: two of E, G and NU are needed"},
      {"MAT1,1,1.,1.,.3\n", "E = 1, G = 1 and NU = 0.3 do not fit"},
      {"MAT1,1,1.,,.5\n", "Poisson"},
      {"MAT1,1,1.,,.3\nMAT1,1,2.,,.3\n", "a.bdf:7: MAT1: there is a material 1 already"},
      {"PSOLID,5,3\n", "a.bdf:6: property 5 has material 3, which is not there"},
      {"PSHELL,5,3,1.\n", "a.bdf:6: property 5 is a PSHELL, and elements of space have it"},
      {"SPC1,1,1,1,THRU\n", "SPC1: THRU ends the list"},
      {"SPC1,1,1,5,THRU,2\n", "5 THRU 2 runs downwards"},
      {"SPC1,1,17,1\n", "'17' are no digits from 1 to 6"},
      {"PLOAD4,8,10,5.,,,,1\n", "PLOAD4: element 10 has no side"}};
  skip_ = mesh::InpSkip::loads;
  for (const auto& [text, expected] : cases) {
    EXPECT_FALSE(import(tetrahedron + text)) << text;
    EXPECT_NE(messages().find(expected), std::string::npos) << text << messages();
    EXPECT_EQ(model_.mesh.element_count(), 0U);
  }
  EXPECT_FALSE(import("+A,1\n" + tetrahedron));
  EXPECT_NE(messages().find("a.bdf:1: the line continues 'A', and no entry stands before it"),
            std::string::npos)
      << messages();
  EXPECT_FALSE(import(""));
  EXPECT_NE(messages().find("no elements"), std::string::npos) << messages();
  EXPECT_FALSE(import("SOL 101\nCEND\n"));
  EXPECT_NE(messages().find("no BEGIN BULK"), std::string::npos) << messages();
  EXPECT_FALSE(import("GRID,1\nGRID,2,,1.\nGRID,3,,0.,1.\nGRID,4,,0.,1.,1.\nCQUAD4,1,1,1,2,3,4\n"));
  EXPECT_NE(messages().find("do not lie in the plane z = 0"), std::string::npos) << messages();
}

// Whatever stands in a file: it is read, or told what is wrong.
TEST_F(Nastran, DamagedFilesEndInAMessage) {
  std::string whole = text_of(samples[0], test::NastranFieldFormat::narrow, true) + "\n";
  whole = whole.substr(0, whole.find("ENDDATA")) + tetrahedron.substr(tetrahedron.find("CTETRA")) +
          "CTRIA3,20,8,1,2,3\nPSOLID,3,2\nMAT1,2,1.,,.3\nCORD2R,7,0,0.,0.,0.,0.,0.,1.\n"
          ",1.,0.,0.\nSPC1,1,123,1,THRU,9\nPLOAD4,2,7,1.,,,,1,3\nSET3,4,GRID,1,THRU,3\n"
          "FORCE,3,1,,1.,1.\n";
  std::mt19937 random(7);
  const auto below = [&](std::size_t n) { return std::size_t{random() % n}; };
  skip_ = mesh::InpSkip::all;
  std::size_t sound = 0;
  for (int n = 0; n < 400; ++n) {
    std::string text = whole;
    for (std::size_t change = 0; change < 1 + below(3); ++change) {
      const std::size_t at = below(text.size());
      switch (below(4)) {
      case 0:
        text[at] = static_cast<char>(below(256));
        break;
      case 1:
        text.erase(at, 1 + below(80));
        break;
      case 2:
        text.insert(at, std::string("+*,$-.0\n\tTHRU9").substr(below(12)));
        break;
      default:
        text.insert(at, text.substr(below(text.size()), 1 + below(200)));
      }
    }
    const bool read = import(text);
    sound += read ? 1U : 0U;
    EXPECT_EQ(read, model_.mesh.element_count() > 0) << text << messages();
  }
  EXPECT_GT(sound, 20U);
  EXPECT_LT(sound, 300U);
}

TEST_F(Nastran, FilesAreKnownByWhatTheyHold) {
  const std::vector<std::pair<std::string, std::string>> files{
      {"NASTRAN", "$ a comment\n$ another\nGRID           1             0.0     0.0     0.0\n"},
      {"NASTRAN", "SOL 101\nCEND\nBEGIN BULK\n"},
      {"NASTRAN", "grid,1,,0.,0.\n"},
      {"INP", "** made by hand\n*HEADING\n"},
      {"MSH", "$MeshFormat\n4.1 0 8\n"},
      {"", "    -1\n  2411\n         1\n"},
      {"none", "! a deck\n$DECK VERSION=1 LENGTH=mm FORCE=N\n$NSET NAME=GRID\n  1\n"},
      {"none", "SetFactory(\"OpenCASCADE\");\nPoint(1) = {0, 0, 0};\n"},
      {"none", "-1\n0.5\n"}};
  for (const auto& [format, text] : files) {
    write("some.dat", text);
    const mesh::MeshFileKind* kind = mesh::recognise_mesh_file(folder_ / "some.dat");
    EXPECT_EQ(kind == nullptr ? "none" : std::string(kind->format), format) << text;
  }
  write("a.med", "x");
  const mesh::MeshFileKind* med = mesh::recognise_mesh_file(folder_ / "a.med");
  ASSERT_NE(med, nullptr);
  EXPECT_NE(mesh::mesh_file_remedy(*med, "a.med").find("gmsh a.unv -save -o a.msh"),
            std::string::npos);
  EXPECT_EQ(mesh::recognise_mesh_file(folder_ / "gone"), nullptr);
}

} // namespace
} // namespace spricka::test_nastran_import
