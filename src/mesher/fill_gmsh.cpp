// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesher/answers.hpp"

#include "base/by_dimension.hpp"
#include "mesh/plane.hpp"
#include "mesher/gmsh_session.hpp"

#include <gmsh.h>

#include <array>
#include <unordered_map>
#include <utility>
#include <vector>

namespace spricka::mesher {
namespace {

using mesh::PlaneRegion;
using mesh::SolidRegion;

namespace geo = gmsh::model::geo;

constexpr int filled = 1; ///< the surface or the volume

/// One line, and later one element edge, from a point to the next.
int add_line(int from, int to) {
  return geo::addLine(from + 1, to + 1);
}

void describe(const PlaneRegion& region) {
  for (std::size_t i = 0; i < region.points.size(); ++i) {
    geo::addPoint(region.points[i].x(), region.points[i].y(), 0.0, 0.0, static_cast<int>(i) + 1);
  }
  std::vector<int> loops;
  for (const std::vector<int>& loop : region.boundaries) {
    std::vector<int> lines;
    for (std::size_t i = 0; i < loop.size(); ++i) {
      lines.push_back(add_line(loop[i], loop[(i + 1) % loop.size()]));
    }
    const int tag = geo::addCurveLoop(lines);
    const bool outer = mesh::twice_area(region.points, loop) > 0.0;
    loops.insert(outer ? loops.begin() : loops.end(), tag); // gmsh wants the outer one first
  }
  geo::addPlaneSurface(loops, filled);
  std::vector<int> inner;
  for (const std::vector<int>& chain : region.embedded) {
    for (std::size_t i = 0; i + 1 < chain.size(); ++i) {
      inner.push_back(add_line(chain[i], chain[i + 1]));
    }
  }
  geo::synchronize();
  gmsh::model::mesh::embed(1, inner, 2, filled);
  gmsh::vectorpair lines;
  gmsh::model::getEntities(lines, 1);
  for (const auto& [dim, tag] : lines) {
    gmsh::model::mesh::setTransfiniteCurve(tag, 2);
  }
}

/// Triangles given to gmsh, as surfaces that have a mesh and no geometry.
class DiscreteSurfaces {
public:
  explicit DiscreteSurfaces(const SolidRegion& region)
      : region_(region), given_(region.points.size(), false) {}

  int add(const std::vector<std::array<int, 3>>& triangles) {
    const int tag = gmsh::model::addDiscreteEntity(2);
    std::vector<std::size_t> tags;
    std::vector<std::size_t> corners;
    std::vector<double> x;
    for (const std::array<int, 3>& t : triangles) {
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

void describe(const SolidRegion& region) {
  DiscreteSurfaces surfaces(region);
  std::vector<int> loops;
  for (const auto& shell : region.boundaries) {
    loops.push_back(geo::addSurfaceLoop({surfaces.add(shell)}));
  }
  std::vector<std::array<int, 3>> cracks;
  for (const auto& triangles : region.embedded) {
    cracks.insert(cracks.end(), triangles.begin(), triangles.end());
  }
  const int crack = cracks.empty() ? 0 : surfaces.add(cracks);
  geo::addVolume(loops, filled);
  geo::synchronize();
  if (crack != 0) {
    gmsh::model::mesh::embed(2, {crack}, 3, filled);
  }
}

/// The places in a region of its points, by gmsh's tags of their nodes.
std::unordered_map<std::size_t, int> numbers_of_points(const PlaneRegion& region) {
  std::unordered_map<std::size_t, int> index;
  std::vector<std::size_t> tags;
  std::vector<double> x;
  std::vector<double> parametric;
  for (std::size_t i = 0; i < region.points.size(); ++i) {
    gmsh::model::mesh::getNodes(tags, x, parametric, 0, static_cast<int>(i) + 1);
    for (const std::size_t tag : tags) {
      index[tag] = static_cast<int>(i);
    }
  }
  return index;
}

std::unordered_map<std::size_t, int> numbers_of_points(const SolidRegion& region) {
  std::unordered_map<std::size_t, int> index;
  for (std::size_t i = 0; i < region.points.size(); ++i) {
    index[i + 1] = static_cast<int>(i);
  }
  return index;
}

/// Points and cells out of gmsh, in the order of its tags.
template <int dim> void collect(const mesh::FillRegion<dim>& region, mesh::MeshFill<dim>& filling) {
  std::unordered_map<std::size_t, int> index = numbers_of_points(region);
  std::vector<std::size_t> tags;
  std::vector<double> x;
  std::vector<double> parametric;
  gmsh::model::mesh::getNodes(tags, x, parametric, dim, filled);
  for (std::size_t i = 0; i < tags.size(); ++i) {
    index[tags[i]] = static_cast<int>(region.points.size() + filling.added.size());
    filling.added.emplace_back(Eigen::Map<const Eigen::Matrix<double, dim, 1>>(&x[3 * i]));
  }
  std::vector<std::size_t> elements;
  std::vector<std::size_t> nodes;
  constexpr int type = base::ByDimension{2, 4}.at(dim); // triangles, tetrahedra
  constexpr std::size_t corners = dim + 1;
  gmsh::model::mesh::getElementsByType(type, elements, nodes, filled);
  for (std::size_t i = 0; i + corners <= nodes.size(); i += corners) {
    std::array<int, corners>& cell = filling.cells.emplace_back();
    for (std::size_t k = 0; k < corners; ++k) {
      const auto at = index.find(nodes[i + k]);
      if (at == index.end()) {
        filling.trouble = base::ByDimension{"an edge was divided", "a side was divided"}.at(dim);
        return;
      }
      cell[k] = at->second;
    }
  }
}

/// Describes a region to gmsh, whose options are set, and has it filled.
template <int dim>
mesh::MeshFill<dim> fill_described(const mesh::FillRegion<dim>& region,
                                   const mesh::SizeGrading<dim>& size) {
  mesh::MeshFill<dim> filling;
  gmsh::option::setNumber("Mesh.ElementOrder", 1);
  gmsh::option::setNumber("Mesh.MeshSizeExtendFromBoundary", 0);
  gmsh::option::setNumber("Mesh.MeshSizeFromPoints", 0);
  try {
    describe(region);
    gmsh::model::mesh::setSizeCallback([&](int, int, double x, double y, double z) {
      return size(base::Vec3(x, y, z).head<dim>());
    });
    gmsh::model::mesh::generate(dim);
    collect(region, filling);
    gmsh::model::mesh::removeSizeCallback();
  } catch (...) { // gmsh throws a string, or what its parts throw; the log has the words
    filling.trouble = "gmsh gave up";
  }
  for (const std::string& line : GmshSession::errors()) {
    filling.trouble += (filling.trouble.empty() ? "" : "; ") + line;
  }
  return filling;
}

} // namespace

mesh::TriangleFill fill_region_by_gmsh(const PlaneRegion& region, const mesh::Grading& size) {
  const GmshSession session;
  gmsh::option::setNumber("Mesh.Algorithm", 5); // Delaunay
  return fill_described(region, size);
}

mesh::TetrahedronFill fill_region_by_gmsh(const SolidRegion& region,
                                          const mesh::SolidGrading& size) {
  const GmshSession session;
  gmsh::option::setNumber("Mesh.Renumber", 0); // our numbers of the nodes
  // HXT does not ask for sizes, the frontal one needs a library that is not there.
  gmsh::option::setNumber("Mesh.Algorithm3D", 1);
  gmsh::option::setNumber("Mesh.Optimize", 1);
  return fill_described(region, size);
}

} // namespace spricka::mesher
