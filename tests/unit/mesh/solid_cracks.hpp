// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "mesh/boundary.hpp"
#include "mesh/generate/generate.hpp"
#include "mesh/quality.hpp"
#include "mesh/tube/insert_solid.hpp"
#include "shape/quadrature.hpp"
#include "shape/solid.hpp"

#include "tests/unit/mesh/meshes.hpp"
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <set>

/// Solid hosts, cracks in them, and what must hold however a crack was cut.
namespace spricka::test {

inline model::Mesh box(base::ElementType type, int n, double half = 4.0) {
  model::Mesh mesh;
  mesh::BlockSpec spec;
  spec.type = type;
  spec.origin = base::Vec3::Constant(-half);
  spec.size = base::Vec3::Constant(2.0 * half);
  spec.nx = spec.ny = spec.nz = n;
  mesh::generate_solid_block(mesh, base::NetId(std::size_t{0}), "", spec);
  return mesh;
}

/// An ellipse with half axes c along the first and a along the second axis of `turn`.
inline mesh::SolidCrack ellipse(const base::Vec3& centre, const Eigen::Matrix3d& turn, double c,
                                double a, int points = 160) {
  mesh::SolidCrack crack;
  crack.crack = base::CrackId(std::size_t{0});
  crack.net = base::NetId(std::size_t{0});
  crack.normal = turn.col(2);
  for (int i = 0; i < points; ++i) {
    const double t = -2.0 * std::numbers::pi * i / points; // t = m x b runs clockwise, seen from b
    crack.front.emplace_back(centre + c * std::cos(t) * turn.col(0) +
                             a * std::sin(t) * turn.col(1));
  }
  return crack;
}

inline mesh::SolidCrack straight(const base::Vec3& from, const base::Vec3& to,
                                 const base::Vec3& normal) {
  mesh::SolidCrack crack;
  crack.crack = base::CrackId(std::size_t{0});
  crack.net = base::NetId(std::size_t{0});
  crack.normal = normal;
  crack.closed = false;
  for (int i = 0; i <= 20; ++i) {
    crack.front.emplace_back(from + i / 20.0 * (to - from));
  }
  return crack;
}

inline Eigen::Matrix3d axes(const base::Vec3& first, const base::Vec3& second) {
  Eigen::Matrix3d turn;
  turn << first, second, first.cross(second);
  return turn;
}

/// A thick ring, or a part of one: radius 1 to 4, height 2, from the block's coordinates.
inline model::Mesh ring(base::ElementType type, int nr, int nt, int nz) {
  model::Mesh mesh;
  mesh::BlockSpec spec;
  spec.type = type;
  spec.origin = base::Vec3(1, 0, 0);
  spec.size = base::Vec3(3, 1, 2);
  spec.nx = nr;
  spec.ny = nt;
  spec.nz = nz;
  mesh::generate_solid_block(mesh, base::NetId(std::size_t{0}), "", spec);
  for (base::Vec3& x : mesh.x) {
    const double angle = 1.5 * std::numbers::pi * x.y();
    x = base::Vec3(x.x() * std::cos(angle), x.x() * std::sin(angle), x.z());
  }
  return mesh;
}

inline std::optional<mesh::CrackedMesh> insert_cracks(const model::Mesh& host,
                                                      const std::vector<mesh::SolidCrack>& cracks,
                                                      const mesh::TubeMeshParameters& tube = {}) {
  base::Diagnostics diagnostics;
  const std::vector<mesh::TubeMeshParameters> tubes(cracks.size(), tube);
  const std::vector<base::SourceSpan> spans(cracks.size());
  auto result = mesh::insert_solid_cracks(host, cracks, tubes, spans, diagnostics);
  for (const auto& d : diagnostics.messages()) {
    if (d.severity == base::Severity::error) {
      ADD_FAILURE() << d.code << " " << d.text;
    }
  }
  return result;
}

inline double area_of(const model::Mesh& mesh, const std::vector<model::Face>& sides,
                      const base::Vec3& normal) {
  double sum = 0.0;
  for (const model::Face& side : sides) {
    const mesh::FaceNodes nodes = mesh::face_nodes(mesh, side);
    // round the face by corners and middles, straight between them
    std::vector<base::Vec3> rim;
    for (std::size_t i = 0; i < nodes.corners; ++i) {
      rim.push_back(mesh.x[nodes.all[i].index()]);
      rim.push_back(mesh.x[nodes.mid_node(i).index()]);
    }
    for (std::size_t i = 2; i < rim.size(); ++i) {
      sum += 0.5 * (rim[i - 1] - rim[0]).cross(rim[i] - rim[0]).dot(normal);
    }
  }
  return sum;
}

/// Area of plane faces, by corners.
inline double flat_area(const model::Mesh& mesh, const std::vector<model::Face>& sides) {
  double sum = 0.0;
  for (const model::Face& side : sides) {
    const mesh::FaceNodes nodes = mesh::face_nodes(mesh, side);
    base::Vec3 twice = base::Vec3::Zero();
    for (std::size_t i = 2; i < nodes.corners; ++i) {
      const base::Vec3& a = mesh.x[nodes.all[0].index()];
      twice += (mesh.x[nodes.all[i - 1].index()] - a).cross(mesh.x[nodes.all[i].index()] - a);
    }
    sum += 0.5 * twice.norm();
  }
  return sum;
}

/// What must hold however a crack was cut.
inline void expect_sound_solid(const model::Mesh& host, const mesh::CrackedMesh& cracked) {
  const model::Mesh& mesh = cracked.mesh;
  const mesh::MeshFaults faults = mesh::find_mesh_faults(mesh);
  EXPECT_TRUE(faults.bad.empty()) << faults.bad.size();
  EXPECT_EQ(cracked.host.size(), mesh.element_count());
  for (std::size_t n = 0; n < host.node_count(); ++n) {
    ASSERT_EQ(host.x[n], mesh.x[n]);
  }
  for (std::size_t e = 0; e < mesh.element_count(); ++e) {
    EXPECT_EQ(mesh.element_net[e], host.element_net[0]);
    EXPECT_EQ(mesh.property[e], host.property[0]);
    if (cracked.host[e].valid()) {
      EXPECT_TRUE(std::ranges::equal(mesh.element_nodes(base::ElementId(e)),
                                     host.element_nodes(cracked.host[e])));
    }
  }
}

/// Sides that have no neighbour are those of the crack's faces and of the surface, besides those of
/// quadrilaterals that meet triangles and these. Quadrilaterals of the surface may have become two.
inline void expect_closed(const model::Mesh& host, const mesh::CrackedMesh& cracked) {
  const model::Mesh& mesh = cracked.mesh;
  std::set<model::Face> faces;
  for (const mesh::CrackFaceNodes& crack : cracked.faces) {
    faces.insert(crack.left_sides.begin(), crack.left_sides.end());
    faces.insert(crack.right_sides.begin(), crack.right_sides.end());
  }
  const auto triangles_of = [](const model::Mesh& m, const model::Face& side) {
    return mesh::face_nodes(m, side).corners - 2;
  };
  const auto area_vector = [&](const model::Face& side) {
    const mesh::FaceNodes nodes = mesh::face_nodes(mesh, side);
    base::Vec3 twice = base::Vec3::Zero();
    for (std::size_t i = 2; i < nodes.corners; ++i) {
      const base::Vec3& a = mesh.x[nodes.all[0].index()];
      twice += (mesh.x[nodes.all[i - 1].index()] - a).cross(mesh.x[nodes.all[i].index()] - a);
    }
    return twice;
  };
  base::Vec3 all = base::Vec3::Zero(); // area vectors of a closed surface cancel
  for (const model::Face& side : mesh::boundary_faces(mesh)) {
    all += faces.contains(side) ? base::Vec3::Zero() : area_vector(side);
  }
  EXPECT_NEAR(all.norm(), 0.0, 1e-9);
  std::size_t surface = 0;
  for (const model::Face& side : mesh::outer_surface_faces(mesh)) {
    surface += faces.contains(side) ? 0 : triangles_of(mesh, side);
  }
  std::size_t before = 0;
  for (const model::Face& side : mesh::boundary_faces(host)) {
    before += triangles_of(host, side);
  }
  EXPECT_EQ(surface, before);
}

inline void expect_crack(const mesh::SolidCrack& crack, const mesh::CrackedMesh& cracked,
                         std::size_t number, double area) {
  const mesh::CrackFaceNodes& faces = cracked.faces[number];
  const model::Mesh& mesh = cracked.mesh;
  ASSERT_EQ(faces.left.size(), faces.right.size());
  ASSERT_EQ(faces.left_sides.size(), faces.right_sides.size());
  // the upper face looks down
  EXPECT_NEAR(area_of(mesh, faces.left_sides, -crack.normal), area, 0.02 * area);
  EXPECT_NEAR(area_of(mesh, faces.right_sides, crack.normal), area, 0.02 * area);
  std::set<base::NodeId> left(faces.left.begin(), faces.left.end());
  std::set<base::NodeId> right(faces.right.begin(), faces.right.end());
  EXPECT_EQ(left.size(), faces.left.size());
  EXPECT_EQ(right.size(), faces.right.size());
  const auto nodes = [&](const std::vector<model::Face>& sides) {
    const auto all = mesh::nodes_of_faces(mesh, sides);
    return std::set<base::NodeId>(all.begin(), all.end());
  };
  EXPECT_EQ(nodes(faces.left_sides), left);
  EXPECT_EQ(nodes(faces.right_sides), right);
  double scale = std::sqrt(area);
  std::size_t single = 0;
  for (std::size_t i = 0; i < faces.left.size(); ++i) {
    EXPECT_EQ(mesh.x[faces.left[i].index()], mesh.x[faces.right[i].index()]);
    EXPECT_NEAR((mesh.x[faces.left[i].index()] - crack.front[0]).dot(crack.normal), 0.0,
                1e-13 * scale);
    single += faces.left[i] == faces.right[i] ? 1 : 0;
  }
  const auto front = std::ranges::find(cracked.fronts, crack.crack, &mesh::CrackFront::crack);
  ASSERT_NE(front, cracked.fronts.end());
  std::size_t on_fronts = 0; // corners and middles, one less of a front that is not closed
  for (const mesh::CrackFront& one : cracked.fronts) {
    on_fronts += one.crack == crack.crack
                     ? 2 * one.points.size() - (one.points.front().at_surface ? 1 : 0)
                     : 0;
  }
  EXPECT_EQ(single, on_fronts);
  double length = 0.0;
  for (const mesh::FrontPoint& point : front->points) {
    const mesh::FrontFrame frame = front->curve->at(point.s);
    // Points near an end that lie closer than half a radius are beside the curve.
    EXPECT_NEAR((frame.x - point.x).norm(), 0.0,
                front->points.front().at_surface ? 1e-3 * point.radius : 1e-12 * scale);
    EXPECT_NEAR((frame.m - point.growth).norm(), 0.0, 1e-12);
    EXPECT_NEAR(frame.b.dot(crack.normal), 1.0, 1e-12);
    length += point.weight;
  }
  EXPECT_NEAR(length, front->curve->length(), 1e-12 * length);
}

/// The slave of a tie lies where it puts it.
inline void expect_ties(const mesh::CrackedMesh& cracked) {
  std::set<base::NodeId> slaves;
  std::set<base::NodeId> masters;
  for (const mesh::HangingNodeTie& tie : cracked.ties) {
    base::Vec3 x = base::Vec3::Zero();
    double sum = 0.0;
    for (std::size_t i = 0; i < tie.master.size(); ++i) {
      x += tie.weight[i] * cracked.mesh.x[tie.master[i].index()];
      sum += tie.weight[i];
      masters.insert(tie.master[i]);
    }
    EXPECT_NEAR((x - cracked.mesh.x[tie.slave.index()]).norm(), 0.0, 1e-12);
    EXPECT_NEAR(sum, 1.0, 1e-14);
    EXPECT_TRUE(slaves.insert(tie.slave).second);
  }
  for (const base::NodeId slave : slaves) {
    EXPECT_FALSE(masters.contains(slave));
  }
}

/// Faces of the face set SKIN, all of a body's surface, whose nodes a node set has.
inline std::vector<model::Face> faces_on_skin(const model::Mesh& mesh,
                                              const std::vector<base::NodeId>& nodes) {
  const auto at = std::ranges::find(mesh.face_sets, "SKIN", &model::FaceSet::name);
  const std::set<model::Face> skin(at->faces.begin(), at->faces.end());
  std::vector<model::Face> faces = mesh::boundary_faces_with_all_nodes_in(mesh, nodes);
  std::erase_if(faces, [&](const model::Face& face) { return !skin.contains(face); });
  return faces;
}

} // namespace spricka::test
