// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/boundary.hpp"
#include "mesh/generate/generate.hpp"
#include "mesh/generate/swept_solid.hpp"
#include "mesh/quality.hpp"
#include "meshes.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

namespace spricka::test_generate {
namespace {

using base::ElementType;

constexpr double pi = std::numbers::pi;

/// Every boundary face is in exactly one of the sets, and only these are.
void expect_sets_cover(const model::Mesh& mesh, const std::vector<std::string>& names) {
  std::vector<model::Face> all;
  for (const std::string& name : names) {
    const auto& set = test::faces(mesh, name).faces;
    all.insert(all.end(), set.begin(), set.end());
  }
  std::sort(all.begin(), all.end());
  EXPECT_EQ(all, mesh::boundary_faces(mesh));
}

void expect_sound(const model::Mesh& mesh) {
  EXPECT_TRUE(mesh::find_invalid_elements(mesh).empty());
  std::set<base::Label> labels(mesh.node_label.begin(), mesh.node_label.end());
  EXPECT_EQ(labels.size(), mesh.node_count());
  EXPECT_EQ(*labels.begin(), 1);
  EXPECT_EQ(*labels.rbegin(), static_cast<base::Label>(mesh.node_count()));
  for (const model::NodeSet& set : mesh.node_sets) {
    EXPECT_FALSE(set.nodes.empty());
  }
  std::vector<bool> used(mesh.node_count(), false);
  for (const base::NodeId n : mesh.nodes) {
    used[n.index()] = true;
  }
  EXPECT_TRUE(std::all_of(used.begin(), used.end(), [](bool b) { return b; }));
  ASSERT_FALSE(mesh.element_sets.empty());
  EXPECT_EQ(mesh.element_sets[0].elements.size(), mesh.element_count());
}

/// Straight or quadratic approximation of a circle's area by n arcs.
double sector_area(double r, double angle, int n, bool quadratic) {
  const double t = angle / n;
  const double chord = 0.5 * r * r * std::sin(t);
  const double sagitta = r * (1.0 - std::cos(0.5 * t));
  return n * (chord + (quadratic ? 2.0 / 3.0 * sagitta * 2.0 * r * std::sin(0.5 * t) : 0.0));
}

class Generate : public testing::TestWithParam<ElementType> {
protected:
  [[nodiscard]] bool quadratic() const { return base::element_info(GetParam()).quadratic; }
};

TEST_P(Generate, Block) {
  model::Mesh mesh;
  mesh::BlockSpec spec;
  spec.type = GetParam();
  spec.origin = {1.0, -2.0, 0.0};
  spec.size = {3.0, 2.0, 1.0};
  spec.nx = 5;
  spec.ny = 3;
  spec.bias = 4.0;
  mesh::generate_block(mesh, base::NetId(std::size_t{0}), "B.", spec);
  expect_sound(mesh);
  EXPECT_NEAR(test::area(mesh), 6.0, 1e-13);
  EXPECT_NEAR(test::chord_length(mesh, test::faces(mesh, "B.YMIN").faces), 3.0, 1e-14);
  EXPECT_NEAR(test::chord_length(mesh, test::faces(mesh, "B.XMAX").faces), 2.0, 1e-14);
  for (const base::NodeId n : mesh::nodes_of_faces(mesh, test::faces(mesh, "B.XMAX").faces)) {
    EXPECT_DOUBLE_EQ(mesh.x[n.index()].x(), 4.0);
  }
  const auto& bottom = test::faces(mesh, "B.YMIN").faces;
  EXPECT_NEAR(test::chord_length(mesh, {bottom.back()}) / test::chord_length(mesh, {bottom[0]}),
              4.0, 1e-12);
  expect_sets_cover(mesh, {"B.XMIN", "B.XMAX", "B.YMIN", "B.YMAX"});
}

TEST_P(Generate, ClosedRing) {
  model::Mesh mesh;
  mesh::RingSpec spec;
  spec.type = GetParam();
  spec.x0 = 5.0;
  spec.ri = 2.0;
  spec.ro = 3.0;
  spec.nr = 3;
  spec.nt = 24;
  spec.bias = 2.0;
  mesh::generate_ring(mesh, base::NetId(std::size_t{0}), "", spec);
  expect_sound(mesh);
  EXPECT_NEAR(test::area(mesh),
              sector_area(3.0, 2 * pi, 24, quadratic()) - sector_area(2.0, 2 * pi, 24, quadratic()),
              1e-12);
  for (const base::NodeId n : mesh::nodes_of_faces(mesh, test::faces(mesh, "INNER").faces)) {
    EXPECT_NEAR((mesh.x[n.index()] - base::Vec3(5, 0, 0)).norm(), 2.0, 1e-15 * 8);
  }
  const auto rings = mesh::build_face_chains(mesh, mesh::boundary_faces(mesh));
  ASSERT_EQ(rings.size(), 2U);
  EXPECT_TRUE(rings[0].closed && rings[1].closed);
  expect_sets_cover(mesh, {"INNER", "OUTER"});
}

TEST_P(Generate, QuarterRing) {
  model::Mesh mesh;
  mesh::RingSpec spec;
  spec.type = GetParam();
  spec.ri = 1.0;
  spec.ro = 4.0;
  spec.t1 = 0.5 * pi;
  spec.nr = 5;
  spec.nt = 6;
  mesh::generate_ring(mesh, base::NetId(std::size_t{0}), "", spec);
  expect_sound(mesh);
  EXPECT_NEAR(test::area(mesh),
              sector_area(4.0, pi / 2, 6, quadratic()) - sector_area(1.0, pi / 2, 6, quadratic()),
              1e-12);
  const auto on_axis =
      std::count_if(mesh.x.begin(), mesh.x.end(), [](const base::Vec3& x) { return x.x() == 0.0; });
  EXPECT_EQ(on_axis, quadratic() ? 11 : 6);
}

TEST_P(Generate, Disc) {
  for (const int nt : {3, 8, 14, 20, 72}) {
    for (const double angle : {2 * pi, pi, pi / 2, 1.0}) {
      for (const int nr : {1, 4}) {
        SCOPED_TRACE(testing::Message() << "nt " << nt << " angle " << angle << " nr " << nr);
        model::Mesh mesh;
        mesh::RingSpec spec;
        spec.type = GetParam();
        spec.ro = 2.0;
        spec.t0 = 0.3;
        spec.t1 = 0.3 + angle;
        spec.nr = nr;
        spec.nt = nt;
        mesh::generate_ring(mesh, base::NetId(std::size_t{0}), "", spec);
        expect_sound(mesh);
        EXPECT_NEAR(test::area(mesh), sector_area(2.0, angle, nt, quadratic()), 1e-11);
        EXPECT_EQ(test::faces(mesh, "OUTER").faces.size(), static_cast<std::size_t>(nt));
        EXPECT_EQ(mesh::build_face_chains(mesh, mesh::boundary_faces(mesh)).size(), 1U);
        if (angle > 6.0) {
          expect_sets_cover(mesh, {"OUTER"});
        }
      }
    }
  }
}

TEST_P(Generate, Lug) {
  for (const int nt : {8, 30, 72}) {
    for (const double length : {4.0, 8.0}) {
      SCOPED_TRACE(testing::Message() << "nt " << nt << " length " << length);
      model::Mesh mesh;
      mesh::LugSpec spec;
      spec.type = GetParam();
      spec.x0 = 1.0;
      spec.ri = 1.5;
      spec.ro = 3.0;
      spec.width = 6.0;
      spec.length = length;
      spec.nr = 4;
      spec.nt = nt;
      mesh::generate_lug(mesh, base::NetId(std::size_t{0}), "L.", spec);
      expect_sound(mesh);
      const int head = (nt + 1) / 2;
      EXPECT_NEAR(test::area(mesh),
                  6.0 * length + sector_area(3.0, pi, head, quadratic()) -
                      sector_area(1.5, pi, head, quadratic()) -
                      sector_area(1.5, pi, nt - head, quadratic()),
                  1e-11);
      for (const base::NodeId n : mesh::nodes_of_faces(mesh, test::faces(mesh, "L.END").faces)) {
        EXPECT_NEAR(mesh.x[n.index()].x(), 1.0 - length, 1e-14 * 8);
      }
      EXPECT_NEAR(test::chord_length(mesh, test::faces(mesh, "L.END").faces), 6.0, 1e-12);
      const auto bore = mesh::build_face_chains(mesh, test::faces(mesh, "L.BORE").faces);
      ASSERT_EQ(bore.size(), 1U);
      EXPECT_TRUE(bore[0].closed);
    }
  }
}

TEST_P(Generate, TaperedLugWithAnOffsetBore) {
  for (const double width : {6.0, 7.0, 14.0}) {
    SCOPED_TRACE(width);
    model::Mesh mesh;
    mesh::LugSpec spec;
    spec.type = GetParam();
    spec.ri = 1.2;
    spec.ro = 3.0;
    spec.ex = 0.5;
    spec.ey = -0.7;
    spec.width = width;
    spec.length = 9.0;
    spec.nt = 40;
    mesh::generate_lug(mesh, base::NetId(std::size_t{0}), "", spec);
    expect_sound(mesh);
    expect_sets_cover(mesh, {"BORE", "HEAD", "SIDES", "END"});
    // the side is a tangent: distance of the head's centre from it is RO
    const double along = spec.length + spec.ex;
    const double up = 0.5 * width;
    const double tilt = std::acos(spec.ro / std::hypot(up, along));
    const double angle = std::atan2(up, -along) - tilt; // of the tangent's point
    const base::Vec3 tangent = 3.0 * base::Vec3(std::cos(angle), std::sin(angle), 0.0);
    const auto head = static_cast<int>(test::faces(mesh, "HEAD").faces.size());
    EXPECT_NEAR(test::area(mesh),
                sector_area(3.0, 2.0 * angle, head, quadratic()) - tangent.x() * tangent.y() +
                    (tangent.x() + along) * (tangent.y() + up) -
                    sector_area(1.2, 2.0 * angle, head, quadratic()) -
                    sector_area(1.2, 2.0 * (pi - angle), 40 - head, quadratic()),
                1e-11);
    for (const base::NodeId n : mesh::nodes_of_faces(mesh, test::faces(mesh, "BORE").faces)) {
      EXPECT_NEAR(mesh.x[n.index()].norm(), 1.2, 1e-14 * 8);
    }
  }
}

mesh::PlateSpec off_centre_plate(ElementType type) {
  mesh::PlateSpec spec;
  spec.type = type;
  spec.origin = {-2.0, 1.0, 0.0};
  spec.size = {20.0, 8.0, 0.0};
  spec.hole = {4.0, 4.0, 0.0};
  spec.ri = 1.0;
  spec.nr = 3;
  spec.nt = 24;
  return spec;
}

TEST_P(Generate, PlateWithAHole) {
  for (const double x : {-0.5, 4.0, 8.0, 16.8}) {
    for (const int nt : {12, 24, 61}) {
      SCOPED_TRACE(testing::Message() << "x " << x << " nt " << nt);
      model::Mesh mesh;
      mesh::PlateSpec spec = off_centre_plate(GetParam());
      spec.hole.x() = x;
      spec.nt = nt;
      mesh::generate_plate(mesh, base::NetId(std::size_t{0}), "P.", spec);
      expect_sound(mesh);
      expect_sets_cover(mesh, {"P.BORE", "P.XMIN", "P.XMAX", "P.YMIN", "P.YMAX"});
      const auto& bore = test::faces(mesh, "P.BORE").faces;
      const auto round = static_cast<int>(bore.size());
      EXPECT_GE(round, nt);
      EXPECT_NEAR(test::area(mesh), 160.0 - sector_area(1.0, 2.0 * pi, round, quadratic()), 1e-10);
      for (const base::NodeId n : mesh::nodes_of_faces(mesh, bore)) {
        EXPECT_NEAR((mesh.x[n.index()] - spec.hole).norm(), 1.0, 1e-14 * 8);
      }
      EXPECT_NEAR(test::chord_length(mesh, test::faces(mesh, "P.YMAX").faces), 20.0, 1e-12);
      const double cells_of_types = base::element_info(GetParam()).corners == 4 ? 1.0 : 2.0;
      EXPECT_GE(mesh::plate_cell_count(spec) * cells_of_types,
                static_cast<double>(mesh.element_count()));
    }
  }
}

INSTANTIATE_TEST_SUITE_P(AllTypes, Generate,
                         testing::Values(ElementType::trim3, ElementType::trimc6,
                                         ElementType::quam4, ElementType::quamc8,
                                         ElementType::quamc9),
                         [](const auto& p) {
                           return std::string(base::element_info(p.param).name);
                         });

TEST(GenerateInOneNet, LabelsContinue) {
  model::Mesh mesh;
  mesh::generate_block(mesh, base::NetId(std::size_t{0}), "", {});
  mesh::generate_block(mesh, base::NetId(std::size_t{0}), "", {});
  mesh::generate_block(mesh, base::NetId(std::size_t{1}), "", {});
  EXPECT_EQ(mesh.element_label, (std::vector<base::Label>{1, 2, 1}));
  EXPECT_EQ(mesh.node_label[8], 9);
  EXPECT_EQ(mesh.node_label[16], 1);
}

class GenerateSolid : public testing::TestWithParam<ElementType> {};
INSTANTIATE_TEST_SUITE_P(Types, GenerateSolid,
                         testing::Values(ElementType::tet4, ElementType::tet10, ElementType::penta6,
                                         ElementType::pentac15, ElementType::hexe8,
                                         ElementType::hexec20, ElementType::hexec27));

TEST_P(GenerateSolid, Block) {
  model::Mesh mesh;
  mesh::BlockSpec spec;
  spec.type = GetParam();
  spec.origin = {1.0, -2.0, 0.5};
  spec.size = {3.0, 2.0, 1.5};
  spec.nx = 4;
  spec.ny = 3;
  spec.nz = 2;
  spec.bias = 4.0;
  mesh::generate_solid_block(mesh, base::NetId(std::size_t{0}), "B.", spec);
  expect_sound(mesh);
  EXPECT_EQ(mesh.dim, 3);
  EXPECT_NEAR(test::area(mesh), 9.0, 1e-13);
  const std::vector<std::string> names{"B.XMIN", "B.XMAX", "B.YMIN", "B.YMAX", "B.ZMIN", "B.ZMAX"};
  expect_sets_cover(mesh, names);
  for (std::size_t s = 0; s < names.size(); ++s) {
    const auto d = static_cast<Eigen::Index>(s / 2);
    const double plane = spec.origin[d] + (s % 2 == 0 ? 0.0 : spec.size[d]);
    for (const base::NodeId n : mesh::nodes_of_faces(mesh, test::faces(mesh, names[s]).faces)) {
      EXPECT_DOUBLE_EQ(mesh.x[n.index()][d], plane);
    }
  }
}

TEST_P(GenerateSolid, ManyCellsShareTheirSides) {
  model::Mesh mesh;
  mesh::BlockSpec spec;
  spec.type = GetParam();
  spec.nx = spec.ny = spec.nz = 12;
  mesh::generate_solid_block(mesh, base::NetId(std::size_t{0}), "", spec);
  EXPECT_NEAR(test::area(mesh), 1.0, 1e-12);
  const std::size_t sides = base::element_info(GetParam()).corners == 4 ? 2 : 1;
  const std::size_t ends = base::element_info(GetParam()).corners == 8 ? 1 : 2;
  EXPECT_EQ(mesh::boundary_faces(mesh).size(), 144 * (4 * sides + 2 * ends));
}

TEST_P(GenerateSolid, SweptPlateAndDisc) {
  const mesh::SweepSpec sweep{.type = GetParam(), .z0 = -1.5, .depth = 2.0, .layers = 3};
  model::Mesh plate;
  mesh::generate_plate(plate, base::NetId(std::size_t{0}), "",
                       off_centre_plate(mesh::swept_plane_type(GetParam())));
  model::Mesh disc; // of quadrilaterals for hexahedra
  mesh::RingSpec ring;
  ring.type = mesh::swept_plane_type(GetParam());
  ring.ri = 0.0;
  ring.ro = 2.0;
  ring.nr = 2;
  ring.nt = 16;
  mesh::generate_ring(disc, base::NetId(std::size_t{0}), "", ring);
  for (const model::Mesh* plane : {&plate, &disc}) {
    model::Mesh mesh;
    mesh::sweep_plane_mesh(mesh, base::NetId(std::size_t{0}), "S.", *plane, sweep);
    expect_sound(mesh);
    EXPECT_EQ(mesh.dim, 3);
    EXPECT_NEAR(test::area(mesh), 2.0 * test::area(*plane), 1e-10);
    std::vector<std::string> names{"S.ZMIN", "S.ZMAX"};
    for (const model::FaceSet& set : plane->face_sets) {
      names.push_back("S." + set.name);
    }
    expect_sets_cover(mesh, names);
    for (const base::NodeId n : mesh::nodes_of_faces(mesh, test::faces(mesh, "S.ZMAX").faces)) {
      EXPECT_DOUBLE_EQ(mesh.x[n.index()].z(), 0.5);
    }
  }
}

TEST(GenerateInSpace, DiscOfTrianglesAndQuadrilateralsFitsTogether) {
  model::Mesh plane;
  mesh::RingSpec ring;
  ring.ri = 0.0;
  ring.nr = 3;
  ring.nt = 22; // no equal sectors: all of it is of triangles
  mesh::generate_ring(plane, base::NetId(std::size_t{0}), "", ring);
  EXPECT_FALSE(mesh::divides_into_quadrilaterals(ring));
  model::Mesh mesh;
  mesh::sweep_plane_mesh(mesh, base::NetId(std::size_t{0}), "", plane,
                         {.type = ElementType::hexec20, .z0 = 0.0, .depth = 1.0, .layers = 2});
  expect_sound(mesh);
  EXPECT_EQ(mesh.type.front(), ElementType::pentac15);
  expect_sets_cover(mesh, {"OUTER", "ZMIN", "ZMAX"});
}

// A slip of the hand is counted, not laid out.
TEST(Plate, CountsABillionOfRingsAtOnce) {
  mesh::PlateSpec spec = off_centre_plate(ElementType::quamc8);
  spec.nr = 1'000'000'000;
  EXPECT_GE(mesh::plate_cell_count(spec), 1e9 * spec.nt);
}

} // namespace
} // namespace spricka::test_generate
