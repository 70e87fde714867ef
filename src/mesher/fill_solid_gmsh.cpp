// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesher/answers.hpp"
#include "mesher/gmsh_session.hpp"

#include <gmsh.h>

#include <array>
#include <unordered_map>
#include <vector>

namespace spricka::mesher {
namespace {

using mesh::SolidRegion;
using mesh::TetrahedronFill;

constexpr int body = 1;

/// Triangles given to gmsh, as surfaces that have a mesh and no geometry.
class DiscreteSurfaces {
public:
  explicit DiscreteSurfaces(const SolidRegion& region)
      : region_(region), given_(region.points.size(), false) {}

  int add(const std::vector<SolidRegion::Triangle>& triangles) {
    const int tag = gmsh::model::addDiscreteEntity(2);
    std::vector<std::size_t> tags;
    std::vector<std::size_t> corners;
    std::vector<double> x;
    for (const SolidRegion::Triangle& t : triangles) {
      for (const int n : t) {
        const auto i = static_cast<std::size_t>(n);
        corners.push_back(i + 1);
        if (!given_[i]) { // a node belongs to the first surface that has it
          given_[i] = true;
          tags.push_back(i + 1);
          x.insert(x.end(), region_.points[i].begin(), region_.points[i].end());
        }
      }
    }
    gmsh::model::mesh::addNodes(2, tag, tags, x);
    constexpr int triangle = 2;
    gmsh::model::mesh::addElementsByType(tag, triangle, {}, corners);
    return tag;
  }

private:
  const SolidRegion& region_;
  std::vector<bool> given_;
};

void describe_solid(const SolidRegion& region) {
  DiscreteSurfaces surfaces(region);
  std::vector<int> loops;
  for (const auto& shell : region.shells) {
    loops.push_back(gmsh::model::geo::addSurfaceLoop({surfaces.add(shell)}));
  }
  const int crack = region.embedded.empty() ? 0 : surfaces.add(region.embedded);
  gmsh::model::geo::addVolume(loops, body);
  gmsh::model::geo::synchronize();
  if (crack != 0) {
    gmsh::model::mesh::embed(2, {crack}, 3, body);
  }
}

void collect_solid(const SolidRegion& region, TetrahedronFill& filling) {
  std::unordered_map<std::size_t, int> index;
  for (std::size_t i = 0; i < region.points.size(); ++i) {
    index[i + 1] = static_cast<int>(i);
  }
  std::vector<std::size_t> tags;
  std::vector<double> x;
  std::vector<double> parametric;
  gmsh::model::mesh::getNodes(tags, x, parametric, 3, body);
  for (std::size_t i = 0; i < tags.size(); ++i) {
    index[tags[i]] = static_cast<int>(region.points.size() + filling.added.size());
    filling.added.emplace_back(x[3 * i], x[3 * i + 1], x[3 * i + 2]);
  }
  std::vector<std::size_t> elements;
  std::vector<std::size_t> nodes;
  constexpr int tetrahedron = 4;
  gmsh::model::mesh::getElementsByType(tetrahedron, elements, nodes, body);
  for (std::size_t i = 0; i + 3 < nodes.size(); i += 4) {
    std::array<int, 4> t{};
    for (std::size_t k = 0; k < 4; ++k) {
      const auto at = index.find(nodes[i + k]);
      if (at == index.end()) {
        filling.trouble = "a side was divided";
        return;
      }
      t[k] = at->second;
    }
    filling.tetrahedra.push_back(t);
  }
}

} // namespace

TetrahedronFill fill_solid_region(const SolidRegion& region, const mesh::SolidGrading& size) {
  TetrahedronFill filling;
  const GmshSession session;
  gmsh::option::setNumber("Mesh.Renumber", 0); // our numbers of the nodes
  // HXT does not ask for sizes, the frontal one needs a library that is not there.
  gmsh::option::setNumber("Mesh.Algorithm3D", 1);
  gmsh::option::setNumber("Mesh.Optimize", 1);
  gmsh::option::setNumber("Mesh.ElementOrder", 1);
  gmsh::option::setNumber("Mesh.MeshSizeExtendFromBoundary", 0);
  gmsh::option::setNumber("Mesh.MeshSizeFromPoints", 0);
  try {
    describe_solid(region);
    gmsh::model::mesh::setSizeCallback(
        [&](int, int, double x, double y, double z) { return size(base::Vec3(x, y, z)); });
    gmsh::model::mesh::generate(3);
    collect_solid(region, filling);
    gmsh::model::mesh::removeSizeCallback();
  } catch (...) { // gmsh throws a string, or what its parts throw; the log has the words
    filling.trouble = "gmsh gave up";
  }
  for (const std::string& line : GmshSession::errors()) {
    filling.trouble += (filling.trouble.empty() ? "" : "; ") + line;
  }
  return filling;
}

} // namespace spricka::mesher
