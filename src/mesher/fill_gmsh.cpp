// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesher/answers.hpp"

#include "mesh/plane.hpp"
#include "mesher/gmsh_session.hpp"

#include <gmsh.h>

#include <unordered_map>
#include <utility>

namespace spricka::mesher {
namespace {

using mesh::Grading;
using mesh::PlaneRegion;
using mesh::TriangleFill;

namespace geo = gmsh::model::geo;
using base::Vec2;

constexpr int surface = 1;

double twice_area(const PlaneRegion& region, const std::vector<int>& loop) {
  double sum = 0.0;
  for (std::size_t i = 0, j = loop.size() - 1; i < loop.size(); j = i++) {
    sum += mesh::cross(region.points[static_cast<std::size_t>(loop[j])],
                       region.points[static_cast<std::size_t>(loop[i])]);
  }
  return sum;
}

/// One line, and later one element edge, from a point to the next.
int add_line(int from, int to) {
  return geo::addLine(from + 1, to + 1);
}

void describe(const PlaneRegion& region) {
  for (std::size_t i = 0; i < region.points.size(); ++i) {
    geo::addPoint(region.points[i].x(), region.points[i].y(), 0.0, 0.0, static_cast<int>(i) + 1);
  }
  std::vector<int> loops;
  for (const std::vector<int>& loop : region.loops) {
    std::vector<int> lines;
    for (std::size_t i = 0; i < loop.size(); ++i) {
      lines.push_back(add_line(loop[i], loop[(i + 1) % loop.size()]));
    }
    const int tag = geo::addCurveLoop(lines);
    const bool outer = twice_area(region, loop) > 0.0;
    loops.insert(outer ? loops.begin() : loops.end(), tag); // gmsh wants the outer one first
  }
  geo::addPlaneSurface(loops, surface);
  std::vector<int> inner;
  for (const std::vector<int>& chain : region.embedded) {
    for (std::size_t i = 0; i + 1 < chain.size(); ++i) {
      inner.push_back(add_line(chain[i], chain[i + 1]));
    }
  }
  geo::synchronize();
  gmsh::model::mesh::embed(1, inner, 2, surface);
  gmsh::vectorpair lines;
  gmsh::model::getEntities(lines, 1);
  for (const auto& [dim, tag] : lines) {
    gmsh::model::mesh::setTransfiniteCurve(tag, 2);
  }
}

/// Points and triangles out of gmsh, in the order of its tags.
void collect(const PlaneRegion& region, TriangleFill& filling) {
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
  gmsh::model::mesh::getNodes(tags, x, parametric, 2, surface);
  for (std::size_t i = 0; i < tags.size(); ++i) {
    index[tags[i]] = static_cast<int>(region.points.size() + filling.added.size());
    filling.added.emplace_back(x[3 * i], x[3 * i + 1]);
  }
  std::vector<std::size_t> elements;
  std::vector<std::size_t> nodes;
  constexpr int triangle = 2;
  gmsh::model::mesh::getElementsByType(triangle, elements, nodes, surface);
  for (std::size_t i = 0; i < nodes.size(); i += 3) {
    std::array<int, 3> t{};
    for (std::size_t k = 0; k < 3; ++k) {
      const auto at = index.find(nodes[i + k]);
      if (at == index.end()) {
        filling.trouble = "an edge was divided";
        return;
      }
      t[k] = at->second;
    }
    filling.triangles.push_back(t);
  }
}

} // namespace

TriangleFill fill_region(const PlaneRegion& region, const Grading& size) {
  TriangleFill filling;
  const GmshSession session;
  gmsh::option::setNumber("Mesh.Algorithm", 5); // Delaunay
  gmsh::option::setNumber("Mesh.ElementOrder", 1);
  gmsh::option::setNumber("Mesh.MeshSizeExtendFromBoundary", 0);
  gmsh::option::setNumber("Mesh.MeshSizeFromPoints", 0);
  try {
    describe(region);
    gmsh::model::mesh::setSizeCallback(
        [&](int, int, double x, double y, double) { return size(Vec2(x, y)); });
    gmsh::model::mesh::generate(2);
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

} // namespace spricka::mesher
