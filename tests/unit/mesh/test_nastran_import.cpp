// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/import/nastran_card.hpp"
#include "mesh/import/nastran_import.hpp"
#include "mesh/import/recognise_mesh_file.hpp"
#include "mesh/quality.hpp"
#include "meshes.hpp"
#include "model/model.hpp"
#include "shape/topology.hpp"

#include <gtest/gtest.h>

#include <fmt/format.h>

#include <fstream>
#include <random>
#include <unistd.h>

namespace spricka::test_nastran_import {
namespace {

namespace fs = std::filesystem;

enum class FieldFormat { narrow, wide, free };

/// One entry in small, large or free fields, with the lines that continue it.
std::string entry(FieldFormat format, const std::string& name,
                  const std::vector<std::string>& fields) {
  const std::size_t width = format == FieldFormat::wide ? 4 : 8;
  std::string text;
  for (std::size_t i = 0; i < fields.size(); ++i) {
    if (i % width == 0) {
      const std::string first = i == 0 ? name : format == FieldFormat::wide ? "*" : "+";
      const std::string star = i == 0 && format == FieldFormat::wide ? "*" : "";
      text += i == 0                        ? ""
              : format == FieldFormat::free ? ",+\n"
              : format == FieldFormat::wide ? "*\n"
                                            : "+\n";
      text += format == FieldFormat::free ? first : fmt::format("{:<8}", first + star);
    }
    text += format == FieldFormat::free     ? "," + fields[i]
            : format == FieldFormat::narrow ? fmt::format("{:>8}", fields[i])
                                            : fmt::format("{:>16}", fields[i]);
  }
  return text + "\n";
}

std::vector<std::string> words(const std::vector<int>& numbers) {
  std::vector<std::string> text;
  for (const int n : numbers) {
    text.push_back(std::to_string(n));
  }
  return text;
}

class Nastran : public testing::Test {
protected:
  void SetUp() override {
    folder_ = fs::temp_directory_path() / ("spricka-nastran-" + std::to_string(getpid()));
    fs::create_directories(folder_);
  }
  void TearDown() override { fs::remove_all(folder_); }

  void write(const std::string& name, const std::string& text) const {
    std::ofstream(folder_ / name, std::ios::binary) << text;
  }
  /// True without an error; the result is in model_ and diagnostics_.
  bool import(const std::string& text) {
    write("a.bdf", text);
    mesh::ImportRequest request;
    request.file = folder_ / "a.bdf";
    request.net = base::NetId(std::size_t{0});
    request.renames = renames_;
    request.skip = skip_;
    model_ = {};
    diagnostics_ = {};
    mesh::append_materials_and_equations(model_,
                                         mesh::import_nastran(model_.mesh, request, diagnostics_));
    return !diagnostics_.has_errors();
  }
  /// All messages, one a line.
  [[nodiscard]] std::string messages() const {
    std::string all;
    for (const base::Diagnostic& d : diagnostics_.messages()) {
      all += d.code + " " + d.text + " = " + d.hint + "\n";
    }
    return all;
  }
  [[nodiscard]] std::vector<base::Label> labels(const std::string& node_set) const {
    std::vector<base::Label> result;
    for (const model::NodeSet& set : model_.mesh.node_sets) {
      for (const base::NodeId n : set.name == node_set ? set.nodes : std::vector<base::NodeId>()) {
        result.push_back(model_.mesh.node_label[n.index()]);
      }
    }
    return result;
  }
  [[nodiscard]] std::size_t elements(const std::string& name) const {
    for (const model::ElementSet& set : model_.mesh.element_sets) {
      if (set.name == name) {
        return set.elements.size();
      }
    }
    return 0;
  }

  fs::path folder_;
  std::vector<std::pair<std::string, std::string>> renames_;
  mesh::InpSkip skip_ = mesh::InpSkip::nothing;
  model::Model model_;
  base::Diagnostics diagnostics_;
};

using Edges = std::vector<std::pair<int, int>>;

/// A single element: its corners, and the edges that the quick reference guide puts the further
/// nodes on, in its order.
struct Sample {
  std::string name;
  base::ElementType linear, quadratic;
  std::vector<base::Vec3> corners;
  Edges edges;
  double volume;
};
const std::vector<Sample> samples{
    {"CHEXA",
     base::ElementType::hexe8,
     base::ElementType::hexec20,
     {{0, 0, 0}, {2, 0, 0}, {2, 1, 0}, {0, 1, 0}, {0, 0, 1}, {2, 0, 1}, {2, 1, 1}, {0, 1, 1}},
     {{1, 2},
      {2, 3},
      {3, 4},
      {4, 1},
      {1, 5},
      {2, 6},
      {3, 7},
      {4, 8},
      {5, 6},
      {6, 7},
      {7, 8},
      {8, 5}},
     2.0},
    {"CPENTA",
     base::ElementType::penta6,
     base::ElementType::pentac15,
     {{0, 0, 0}, {2, 0, 0}, {0, 1, 0}, {0, 0, 1}, {2, 0, 1}, {0, 1, 1}},
     {{1, 2}, {2, 3}, {3, 1}, {1, 4}, {2, 5}, {3, 6}, {4, 5}, {5, 6}, {6, 4}},
     1.0},
    {"CTETRA",
     base::ElementType::tet4,
     base::ElementType::tet10,
     {{0, 0, 0}, {3, 0, 0}, {0, 1, 0}, {0, 0, 1}},
     {{1, 2}, {2, 3}, {3, 1}, {1, 4}, {2, 4}, {3, 4}},
     0.5},
    {"CQUAD8",
     base::ElementType::quam4,
     base::ElementType::quamc8,
     {{0, 0, 0}, {2, 0, 0}, {2, 1, 0}, {0, 1, 0}},
     {{1, 2}, {2, 3}, {3, 4}, {4, 1}},
     2.0},
    {"CTRIA6",
     base::ElementType::trim3,
     base::ElementType::trimc6,
     {{0, 0, 0}, {2, 0, 0}, {0, 1, 0}},
     {{1, 2}, {2, 3}, {3, 1}},
     1.0}};

std::string grid(FieldFormat format, int label, const base::Vec3& x) {
  return entry(format, "GRID",
               {std::to_string(label), "", fmt::format("{:.3f}", x.x()),
                fmt::format("{:.3f}", x.y()), fmt::format("{:.3f}", x.z())});
}

/// The text of one element; `mirror` changes its sense.
std::string text_of(const Sample& sample, FieldFormat format, bool middles, bool mirror = false) {
  const auto at = [&](const base::Vec3& x) {
    return mirror ? base::Vec3(-x.x(), x.y(), x.z()) : x;
  };
  std::string text = "SOL 101\nCEND\nSPC = 1\nBEGIN BULK\n$ comment\n";
  std::vector<int> fields{7, 3};
  int label = 0;
  for (const base::Vec3& x : sample.corners) {
    text += grid(format, ++label, at(x));
    fields.push_back(label);
  }
  for (const auto& [a, b] : middles ? sample.edges : Edges()) {
    text += grid(format, ++label,
                 at(0.5 * (sample.corners[static_cast<std::size_t>(a) - 1] +
                           sample.corners[static_cast<std::size_t>(b) - 1])));
    fields.push_back(label);
  }
  return text + entry(format, sample.name, words(fields)) + "ENDDATA\nrubbish\n";
}

TEST_F(Nastran, NodesOfEveryElementLieOnTheirEdgesInEachFormat) {
  for (const Sample& sample : samples) {
    for (const bool middles : {false, true}) {
      for (const bool mirror : {false, true}) {
        SCOPED_TRACE(sample.name + (middles ? " middles" : "") + (mirror ? " mirrored" : ""));
        ASSERT_TRUE(import(text_of(sample, FieldFormat::narrow, middles, mirror))) << messages();
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
        for (const FieldFormat format : {FieldFormat::wide, FieldFormat::free}) {
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

// One tetrahedron, in lines that other tests add to.
const std::string tetrahedron = R"(GRID,1,,0.,0.,0.
GRID,2,,1.,0.,0.
GRID,3,,0.,1.,0.
GRID,4,,0.,0.,1.
CTETRA,10,5,1,2,3,4
)";
// A square with its lower edge as a bar.
const std::string square = R"(GRID,1,,0.,0.,0.
GRID,2,,1.,0.,0.
GRID,3,,1.,1.,0.
GRID,4,,0.,1.,0.
CQUAD4,10,5,1,2,3,4
)";

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
    grids += grid(FieldFormat::narrow, static_cast<int>(i) + 1, samples[0].corners[i]);
  }
  for (const std::string& form : forms) {
    ASSERT_TRUE(import(grids + form)) << form << messages();
    EXPECT_NEAR(test::area(model_.mesh), 2.0, 1e-14) << form;
  }
}

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
  const auto side = [&](const Sample& sample, const std::string& corners) {
    std::string text = text_of(sample, FieldFormat::free, false);
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
  std::string whole = text_of(samples[0], FieldFormat::narrow, true) + "\n";
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
