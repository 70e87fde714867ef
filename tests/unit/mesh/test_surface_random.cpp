// SPDX-License-Identifier: GPL-3.0-or-later
// Cracks anywhere on bodies of planes, cylinders and other shapes.
#include "mesh/import/gmsh_import.hpp"
#include "surface_checks.hpp"
#include "surface_hosts.hpp"

#include <filesystem>
#include <fstream>
#include <random>

#include <unistd.h>

namespace spricka::mesh::test_surface_random {
namespace {

using base::ElementType;
using base::Vec3;
using test::Ellipse;
using test::SurfaceCut;

/// A body by a geometry script, in quadratic tetrahedra of about this size.
model::Mesh body_of(const std::string& script, double size) {
  const std::filesystem::path folder =
      std::filesystem::temp_directory_path() / ("spricka_surface_" + std::to_string(getpid()));
  std::filesystem::create_directories(folder);
  ImportRequest request;
  request.file = folder / "body.geo";
  request.quadratic = true;
  request.net = base::NetId(0);
  std::ofstream(request.file) << "SetFactory(\"OpenCASCADE\");\n"
                              << script << "Mesh.MeshSizeMax = " << size
                              << ";\nPhysical Volume(\"BODY\") = Volume{:};\n";
  model::Mesh mesh;
  base::Diagnostics diagnostics;
  import_gmsh_mesh_or_script(mesh, request, diagnostics);
  std::filesystem::remove_all(folder);
  EXPECT_FALSE(diagnostics.has_errors());
  return mesh;
}

/// Distance of a place from the nearest feature edge.
double to_feature(const SurfaceGeometry& surface, const Vec3& x) {
  double least = 1e300;
  for (std::size_t e = 0; e < surface.edges().size(); ++e) {
    for (int k = 0; k <= 20 && surface.edges()[e].feature; ++k) {
      least = std::min(least, (surface.place_on_edge(e, 0.1 * k - 1.0).x - x).norm());
    }
  }
  return least;
}

/// Cracks anywhere on a body, but for those nearly along its surface. What is refused must lie near
/// an edge with an end of its front.
void try_random(const model::Mesh& mesh, unsigned seed, int count, double most) {
  const SurfaceGeometry surface(mesh);
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> in(-1.0, 1.0);
  const auto any = [&] { return Vec3(in(random), in(random), in(random)); };
  int refused = 0;
  for (int i = 0; i < count; ++i) {
    const auto nodes = static_cast<double>(mesh.node_count());
    const auto at = static_cast<std::size_t>(0.4999 * (1.0 + in(random)) * nodes);
    const Vec3 centre = surface.nearest_place(mesh.x[at] + 0.1 * most * any()).x;
    const Vec3 u = any().normalized();
    const Vec3 v = u.cross(any()).normalized();
    const double a = most * std::pow(10.0, 0.5 * (in(random)-1.0));
    const Ellipse crack{centre, a * u, a * (0.65 + 0.35 * in(random)) * v};
    const double radius = 0.15 * crack.length();
    if (std::abs(surface.nearest_place(centre).normal.dot(crack.normal())) > 0.94) {
      continue; // less than 20 degrees between the crack and the surface
    }
    const SurfaceCut cut = test::cut_surface(surface, crack, radius);
    if (cut.trouble.empty() && cut.made.trouble.why.empty()) {
      expect_sound(surface, cut);
      continue;
    }
    if (cut.trouble == "the front lies outside of the body") {
      continue;
    }
    ++refused;
    double near = 1e300;
    for (const Vec3& end : cut.ends) {
      near = std::min(near, to_feature(surface, end));
    }
    EXPECT_LT(near, 2.0 * radius) << i << ": " << cut.trouble << cut.made.trouble.why << " at "
                                  << cut.made.trouble.at.transpose() << ", crack at "
                                  << centre.transpose() << " u " << crack.u.transpose() << " v "
                                  << crack.v.transpose();
  }
  EXPECT_LE(refused, count / 4);
}

TEST(SurfaceRandom, CracksInABox) {
  try_random(test::box_host(ElementType::tet10, {2.0, 2.0, 2.0}, 3), 1, 12, 0.5);
  try_random(test::box_host(ElementType::hexec20, {2.0, 2.0, 2.0}, 6), 2, 12, 0.5);
}

TEST(SurfaceRandom, CracksInAPlateWithAHole) {
  try_random(test::hole_plate(ElementType::tet10, {}), 3, 12, 0.6);
  try_random(test::hole_plate(ElementType::hexec20, {}), 4, 12, 0.6);
}

TEST(SurfaceRandom, CracksInALugOfFreeTetrahedra) {
  // The round head goes over into the flanks without an edge.
  const std::string lug = R"(
Box(1) = {-6, -2, 0, 6, 4, 1}; Cylinder(2) = {0, 0, 0, 0, 0, 1, 2};
BooleanUnion(3) = { Volume{1}; Delete; }{ Volume{2}; Delete; };
Cylinder(4) = {0, 0, -1, 0, 0, 3, 1};
BooleanDifference(5) = { Volume{3}; Delete; }{ Volume{4}; Delete; };
)";
  try_random(body_of(lug, 0.8), 5, 8, 0.5);
  try_random(body_of(lug, 0.4), 6, 4, 0.5);
}

TEST(SurfaceRandom, CracksInRoundBodies) {
  try_random(body_of("Sphere(1) = {0, 0, 0, 2};\n", 0.7), 7, 6, 0.6);
  try_random(body_of("Cone(1) = {0, 0, 0, 0, 0, 3, 2, 1};\n", 0.7), 8, 6, 0.6);
  try_random(body_of("Torus(1) = {0, 0, 0, 3, 1};\n", 0.6), 9, 6, 0.4);
}

} // namespace
} // namespace spricka::mesh::test_surface_random
