// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/boundary.hpp"
#include "mesh/import/gmsh_import.hpp"
#include "mesh/quality.hpp"
#include "meshes.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <numbers>

namespace spricka::test_gmsh_import {
namespace {

namespace fs = std::filesystem;

const char* const quarter_disc = R"(DefineConstant[ R = 2 ];
DefineConstant[ h = 0.4 ];
Point(1) = {0, 0, 0, h};
Point(2) = {R, 0, 0, h};
Point(3) = {0, R, 0, h};
Point(9) = {50, 50, 0, h};
Line(1) = {1, 2};
Circle(2) = {2, 1, 3};
Line(3) = {3, 1};
Curve Loop(1) = {1, 2, 3};
Plane Surface(1) = {1};
Physical Surface("Body") = {1};
Physical Curve("arc") = {2};
Physical Point("the tip") = {2};
)";

class GmshImport : public testing::Test {
protected:
  void SetUp() override {
    folder_ =
        fs::temp_directory_path() / (std::string("spricka-test-") +
                                     testing::UnitTest::GetInstance()->current_test_info()->name());
    fs::create_directories(folder_);
  }
  void TearDown() override { fs::remove_all(folder_); }

  mesh::ImportRequest write(const std::string& name, const std::string& text) {
    std::ofstream(folder_ / name) << text;
    mesh::ImportRequest request;
    request.file = folder_ / name;
    request.format = name.ends_with("msh") ? mesh::ImportFormat::msh : mesh::ImportFormat::geo;
    request.net = base::NetId(std::size_t{0});
    return request;
  }
  bool import(const mesh::ImportRequest& request) {
    mesh::import_gmsh_mesh_or_script(mesh_, request, diagnostics_);
    return !diagnostics_.has_errors();
  }

  fs::path folder_;
  model::Mesh mesh_;
  base::Diagnostics diagnostics_;
};

TEST_F(GmshImport, LinearQuarterDisc) {
  ASSERT_TRUE(import(write("a.geo", quarter_disc)));
  EXPECT_TRUE(mesh::find_invalid_elements(mesh_).empty());
  EXPECT_EQ(mesh_.type[0], base::ElementType::trim3);
  ASSERT_EQ(mesh_.element_sets.size(), 1U);
  EXPECT_EQ(mesh_.element_sets[0].name, "BODY");
  EXPECT_EQ(mesh_.element_sets[0].elements.size(), mesh_.element_count());
  const auto all = mesh::boundary_faces(mesh_);
  for (const model::Face& face : test::faces(mesh_, "ARC").faces) {
    EXPECT_TRUE(std::binary_search(all.begin(), all.end(), face));
  }
  for (const base::Vec3& x : mesh_.x) {
    EXPECT_LT(x.norm(), 2.0 + 1e-12); // the stray point is not there
  }
  ASSERT_EQ(mesh_.node_sets.size(), 1U);
  EXPECT_EQ(mesh_.node_sets[0].name, "THE_TIP");
  ASSERT_EQ(mesh_.node_sets[0].nodes.size(), 1U);
  EXPECT_NEAR(mesh_.x[mesh_.node_sets[0].nodes[0].index()].x(), 2.0, 1e-15);
}

TEST_F(GmshImport, QuadraticNodesLieOnTheArc) {
  mesh::ImportRequest request = write("a.geo", quarter_disc);
  request.quadratic = true;
  request.scale = 10.0;
  request.prefix = "DISC.";
  request.parameters = {{"R", 3.0}, {"H", 1.0}, {"UNUSED", 7.0}};
  request.renames = {{"ARC", "RIM"}};
  ASSERT_TRUE(import(request));
  EXPECT_EQ(mesh_.type[0], base::ElementType::trimc6);
  const auto& rim = test::faces(mesh_, "DISC.RIM").faces;
  EXPECT_EQ(rim.size(), 5U); // 3 pi/2 with elements of size 1
  for (const base::NodeId n : mesh::nodes_of_faces(mesh_, rim)) {
    EXPECT_NEAR(mesh_.x[n.index()].norm(), 30.0, 1e-12);
  }
  EXPECT_NEAR(test::area(mesh_), std::numbers::pi * 900.0 / 4.0, 0.02);
  EXPECT_TRUE(mesh::find_invalid_elements(mesh_).empty());
}

// A script that fixes the numbers of elements on its curves (Transfinite Curve) is meshed finer all
// the same, where that is wanted and only there.
TEST_F(GmshImport, CurvesOfFixedNumbersTakeSmallerSizes) {
  mesh::ImportRequest request = write("a.geo", R"(Mesh.ElementOrder = 2;
Point(1) = {-8, 0, 0, 4}; Point(2) = {8, 0, 0, 4}; Point(3) = {0, 0, 0};
Circle(1) = {2, 3, 1}; Line(2) = {1, 2};
Transfinite Curve{1} = 7;
Transfinite Curve{2} = 5;
Curve Loop(1) = {1, 2};
Plane Surface(1) = {1};
Physical Surface("BODY") = {1};
Physical Curve("ROUND") = {1};
Physical Curve("FLAT") = {2};
)");
  const base::Vec2 top(0.0, 8.0);
  const auto wish = [&](double x, double y) { return 0.2 + 0.5 * (base::Vec2(x, y) - top).norm(); };
  std::vector<mesh::SizeMap::SizeRequest> wishes; // the map has the size of the nearest
  for (int i = -80; i <= 80; ++i) {
    for (int k = 0; k <= 80; ++k) {
      wishes.push_back({{0.1 * i, 0.1 * k}, wish(0.1 * i, 0.1 * k), true});
    }
  }
  request.size.map = std::make_shared<const mesh::SizeMap>(std::move(wishes));
  ASSERT_TRUE(import(request));
  EXPECT_TRUE(mesh::find_invalid_elements(mesh_).empty());
  double shortest = 8.0;
  for (const model::Face& face : test::faces(mesh_, "ROUND").faces) {
    const std::vector<base::NodeId> nodes = mesh::nodes_of_faces(mesh_, {face});
    ASSERT_EQ(nodes.size(), 3U);
    double length = 0.0;
    base::Vec2 middle = base::Vec2::Zero();
    for (const base::NodeId n : nodes) {
      const base::Vec3& x = mesh_.x[n.index()];
      EXPECT_NEAR(x.norm(), 8.0, 1e-9);
      middle += x.head<2>() / 3.0;
      length = std::max(
          {length, (x - mesh_.x[nodes[0].index()]).norm(), (x - mesh_.x[nodes[1].index()]).norm()});
    }
    EXPECT_LT(length, 1.3 * wish(middle.x(), middle.y()));
    shortest = std::min(shortest, length);
  }
  EXPECT_LT(shortest, 0.3);
  // the integral of ds / h over the half circle, h rising with the chord, is 14 elements; evenly
  // spaced at the shortest it would be 100
  EXPECT_LT(test::faces(mesh_, "ROUND").faces.size(), 25U);
  EXPECT_EQ(test::faces(mesh_, "FLAT").faces.size(), 4U); // fine enough as it was
}

TEST_F(GmshImport, ParametersDoNotOutliveTheImport) {
  mesh::ImportRequest request = write("a.geo", quarter_disc);
  request.parameters = {{"R", 3.0}};
  ASSERT_TRUE(import(request));
  const std::size_t before = mesh_.node_count();
  request.parameters.clear();
  ASSERT_TRUE(import(request));
  double reach = 0.0;
  for (std::size_t n = before; n < mesh_.node_count(); ++n) {
    reach = std::max(reach, mesh_.x[n].norm());
    EXPECT_GT(mesh_.node_label[n], static_cast<base::Label>(before));
  }
  EXPECT_NEAR(reach, 2.0, 1e-12);
}

TEST_F(GmshImport, QuadrilateralsAndOrder) {
  const std::string text = R"(SetFactory("OpenCASCADE");
Mesh.ElementOrder = 2;
Rectangle(1) = {0, 0, 0, 2, 1};
Transfinite Curve{1, 3} = 5;
Transfinite Curve{2, 4} = 3;
Transfinite Surface{1};
Recombine Surface{1};
)";
  ASSERT_TRUE(import(write("q.geo", text)));
  EXPECT_EQ(mesh_.element_count(), 8U);
  EXPECT_EQ(mesh_.type[0], base::ElementType::quamc8);
  EXPECT_NEAR(test::area(mesh_), 2.0, 1e-13);
  ASSERT_TRUE(import(write("q9.geo", "Mesh.SecondOrderIncomplete = 0;\n" + text)));
  EXPECT_EQ(mesh_.type.back(), base::ElementType::quamc9);
  EXPECT_TRUE(mesh::find_invalid_elements(mesh_).empty());
}

TEST_F(GmshImport, ClockwiseMshIsTurned) {
  const std::string text = R"($MeshFormat
2.2 0 8
$EndMeshFormat
$Nodes
8
3 0 0 0
4 2 0 0
5 2 1 0
6 0 1 0
7 1 0 0
8 2 0.5 0
9 1 1 0
10 0 0.5 0
$EndNodes
$Elements
2
1 8 2 5 1 3 4 7
2 16 2 6 1 3 6 5 4 10 9 8 7
$EndElements
)";
  ASSERT_TRUE(import(write("m.msh", text)));
  EXPECT_NEAR(test::area(mesh_), 2.0, 1e-14);
  EXPECT_EQ(mesh_.node_label.front(), 3);
  EXPECT_EQ(mesh_.node_label.back(), 10);
  ASSERT_EQ(mesh_.face_sets.size(), 1U);
  ASSERT_EQ(mesh_.face_sets[0].faces.size(), 1U);
  const auto nodes = test::nodes_of(mesh_, mesh_.face_sets[0].faces[0]);
  EXPECT_EQ(mesh_.node_label[nodes[0].index()], 3);
  EXPECT_EQ(mesh_.node_label[nodes[1].index()], 4);
  EXPECT_EQ(mesh_.node_label[nodes[2].index()], 7);
}

/// The volume of a body from its sides: 1/3 of the sum of x.n dA needs every side to be flat here
/// and to point outwards.
double volume(const model::Mesh& mesh) {
  double six = 0.0;
  for (const model::Face& face : mesh::boundary_faces(mesh)) {
    const auto nodes = test::nodes_of(mesh, face);
    const bool quad = nodes.size() == 4 || nodes.size() >= 8;
    const std::size_t corners = quad ? 4 : 3;
    for (std::size_t i = 1; i + 1 < corners; ++i) {
      six += mesh.x[nodes[0].index()].dot(
          mesh.x[nodes[i].index()].cross(mesh.x[nodes[i + 1].index()]));
    }
    for (std::size_t i = 0; i < corners && nodes.size() > corners; ++i) { // mids between corners
      const base::Vec3 mid =
          0.5 * (mesh.x[nodes[i].index()] + mesh.x[nodes[(i + 1) % corners].index()]);
      EXPECT_NEAR((mesh.x[nodes[corners + i].index()] - mid).norm(), 0.0, 1e-10);
    }
  }
  return six / 6.0;
}

TEST_F(GmshImport, SolidsInOurNodeOrder) {
  const std::string box = "SetFactory(\"OpenCASCADE\");\nBox(1) = {1, 1, 1, 1, 2, 3};\n";
  ASSERT_TRUE(import(write("t.geo", box + "Mesh.ElementOrder = 2;\n")));
  EXPECT_EQ(mesh_.type[0], base::ElementType::tet10);
  EXPECT_NEAR(volume(mesh_), 6.0, 1e-10);
  const std::string extruded = R"(Point(1) = {0, 0, 0, 1};
Extrude{1, 0, 0}{ Point{1}; Layers{1}; }
Extrude{0, 2, 0}{ Curve{1}; Layers{2}; Recombine; }
Extrude{0, 0, 3}{ Surface{5}; Layers{2}; Recombine; }
Mesh.ElementOrder = 2;
)";
  mesh_ = {};
  ASSERT_TRUE(import(write("h.geo", extruded)));
  EXPECT_EQ(mesh_.dim, 3);
  EXPECT_EQ(mesh_.type[0], base::ElementType::hexec20);
  EXPECT_NEAR(volume(mesh_), 6.0, 1e-10);
  mesh_ = {};
  ASSERT_TRUE(import(write("h27.geo", extruded + "Mesh.SecondOrderIncomplete = 0;\n")));
  EXPECT_EQ(mesh_.type[0], base::ElementType::hexec27);
  EXPECT_NEAR(volume(mesh_), 6.0, 1e-10);
  const std::string wedges = R"(Point(1) = {0, 0, 0, 1};
Extrude{1, 0, 0}{ Point{1}; Layers{1}; }
Extrude{0, 2, 0}{ Curve{1}; Layers{2}; }
Extrude{0, 0, 3}{ Surface{5}; Layers{2}; Recombine; }
Mesh.ElementOrder = 2;
)";
  mesh_ = {};
  ASSERT_TRUE(import(write("w.geo", wedges)));
  EXPECT_EQ(mesh_.type[0], base::ElementType::pentac15);
  EXPECT_NEAR(volume(mesh_), 6.0, 1e-10);
}

TEST_F(GmshImport, MissingFile) {
  mesh::ImportRequest request;
  request.file = folder_ / "none.geo";
  EXPECT_FALSE(import(request));
  EXPECT_NE(diagnostics_.messages()[0].text.find("none.geo"), std::string::npos);
}

TEST_F(GmshImport, ScriptErrorsInGmshsWords) {
  EXPECT_FALSE(import(write("bad.geo", "Point(1) = {0, 0, 0, lc};\nLine(1) = {1, 2;\n")));
  ASSERT_GE(diagnostics_.error_count(), 2U);
  EXPECT_NE(diagnostics_.messages()[0].text.find("line 1: Unknown variable 'lc'"),
            std::string::npos);
  EXPECT_EQ(mesh_.node_count(), 0U);
  // and the library works on afterwards
  base::Diagnostics fresh;
  mesh::import_gmsh_mesh_or_script(mesh_, write("a.geo", quarter_disc), fresh);
  EXPECT_FALSE(fresh.has_errors());
}

TEST_F(GmshImport, OpenLoop) {
  EXPECT_FALSE(import(write("open.geo", "Point(1) = {0, 0, 0};\nPoint(2) = {1, 0, 0};\n"
                                        "Line(1) = {1, 2};\nCurve Loop(1) = {1};\n"
                                        "Plane Surface(1) = {1};\n")));
}

TEST_F(GmshImport, NoElements) {
  EXPECT_FALSE(import(write("empty.geo", "Point(1) = {0, 0, 0};\n")));
  ASSERT_EQ(diagnostics_.error_count(), 1U);
}

TEST_F(GmshImport, UnknownGroupIsNamed) {
  mesh::ImportRequest request = write("a.geo", quarter_disc);
  request.renames = {{"ark", "RIM"}};
  EXPECT_FALSE(import(request));
  EXPECT_NE(diagnostics_.messages()[0].hint.find("arc"), std::string::npos);
}

TEST_F(GmshImport, OutOfPlane) {
  EXPECT_FALSE(import(write("z.geo", "SetFactory(\"OpenCASCADE\");\n"
                                     "Rectangle(1) = {0, 0, 1, 2, 1};\n")));
}

} // namespace
} // namespace spricka::test_gmsh_import
