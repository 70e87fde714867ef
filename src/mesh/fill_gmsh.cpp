// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/fill.hpp"

#include "mesh/gmsh_session.hpp"
#include "mesh/plane.hpp"

#include <gmsh.h>

#include <algorithm>
#include <set>
#include <unordered_map>
#include <utility>

namespace spricka::mesh {
namespace {

namespace geo = gmsh::model::geo;
using base::Vec2;

constexpr int surface = 1;

double twice_area(const Region& region, const std::vector<int>& loop) {
  double sum = 0.0;
  for (std::size_t i = 0, j = loop.size() - 1; i < loop.size(); j = i++) {
    sum += cross(region.points[static_cast<std::size_t>(loop[j])],
                 region.points[static_cast<std::size_t>(loop[i])]);
  }
  return sum;
}

/// One line, and later one element edge, from a point to the next.
int add_line(int from, int to) {
  return geo::addLine(from + 1, to + 1);
}

void describe(const Region& region) {
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
void collect(const Region& region, Filling& filling) {
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

/// Triangles with no height, on three points of a straight boundary: the longest side goes over to
/// the other diagonal of the quadrilateral that it halves. Given edges stay.
class Flips {
public:
  Flips(const Region& region, Filling& filling) : region_(region), filling_(filling) {
    for (const auto* chains : {&region.loops, &region.embedded}) {
      for (const std::vector<int>& chain : *chains) {
        const std::size_t count = chain.size() - (chains == &region.embedded ? 1 : 0);
        for (std::size_t i = 0; i < count; ++i) {
          given_.insert(std::minmax(chain[i], chain[(i + 1) % chain.size()]));
        }
      }
    }
  }

  void run() {
    constexpr int passes = 20; // a row of flat ones takes one for each
    bool more = true;
    for (int pass = 0; pass < passes && more; ++pass) {
      more = false;
      for (std::size_t i = 0; i < filling_.triangles.size(); ++i) {
        more = (is_flat(filling_.triangles[i]) && flip(i)) || more;
      }
    }
  }

private:
  using Triangle = std::array<int, 3>;
  static constexpr double flat = 1e-5; ///< height over longest side

  [[nodiscard]] Vec2 at(int n) const {
    const auto i = static_cast<std::size_t>(n);
    return i < region_.points.size() ? region_.points[i]
                                     : filling_.added[i - region_.points.size()];
  }
  /// The corner before the longest side.
  [[nodiscard]] std::size_t longest(const Triangle& t) const {
    std::size_t best = 0;
    for (std::size_t k = 1; k < 3; ++k) {
      best = (at(t[(k + 1) % 3]) - at(t[k])).norm() > (at(t[(best + 1) % 3]) - at(t[best])).norm()
                 ? k
                 : best;
    }
    return best;
  }
  [[nodiscard]] bool is_flat(const Triangle& t) const {
    const std::size_t k = longest(t);
    const Vec2 side = at(t[(k + 1) % 3]) - at(t[k]);
    return cross(side, at(t[(k + 2) % 3]) - at(t[k])) < flat * side.squaredNorm();
  }
  bool flip(std::size_t i) {
    Triangle& t = filling_.triangles[i];
    const std::size_t k = longest(t);
    const int a = t[k];
    const int c = t[(k + 1) % 3];
    const int b = t[(k + 2) % 3];
    if (given_.contains(std::minmax(a, c))) {
      return false;
    }
    for (Triangle& other : filling_.triangles) {
      for (std::size_t m = 0; m < 3; ++m) {
        if (other[m] == c && other[(m + 1) % 3] == a) {
          const int d = other[(m + 2) % 3];
          t = {a, d, b};
          other = {d, c, b};
          return true;
        }
      }
    }
    return false;
  }

  const Region& region_;
  Filling& filling_;
  std::set<std::pair<int, int>> given_;
};

} // namespace

Filling fill(const Region& region, const Grading& size) {
  Filling filling;
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
    Flips(region, filling).run();
    gmsh::model::mesh::removeSizeCallback();
  } catch (...) { // gmsh throws a string, or what its parts throw; the log has the words
    filling.trouble = "gmsh gave up";
  }
  for (const std::string& line : GmshSession::errors()) {
    filling.trouble += (filling.trouble.empty() ? "" : "; ") + line;
  }
  if (filling.trouble.empty() && filling.triangles.empty()) {
    filling.trouble = "no triangles were made";
  }
  return filling;
}

} // namespace spricka::mesh
