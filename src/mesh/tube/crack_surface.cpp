// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/tube/crack_surface.hpp"

#include "geometry/polyline.hpp"
#include "mesh/cut/crack_node_fan.hpp"
#include "mesh/link/fill.hpp"
#include "mesh/link/grading.hpp"
#include "mesh/plane.hpp"
#include "mesh/surface/surface_trace.hpp"

#include <algorithm>
#include <map>

namespace spricka::mesh {
namespace {

using base::Vec2;
using base::Vec3;

/// No point of a line nearer to a tube or a mouth than this part of the size of elements there.
constexpr double least_of_size = 0.5;
/// A node of a mouth so near to where the line meets it is its end.
constexpr double at_mouth = 0.05;

struct KinkLinePoint {
  int node = -1; ///< of the net, where the line begins or ends at a mouth; else a new one:
  base::Vec3 x = base::Vec3::Zero(); ///< there
  double size = 0.0;                 ///< of elements
};
/// Where a crack that has turned is bent: a line that its faces have edges along.
struct KinkLine {
  std::vector<KinkLinePoint> points;
  bool closed = false; ///< the first point not repeated
};

class BendLines {
public:
  BendLines(const CrackDistanceField& reach, const FillSizes& fill, const std::vector<int>& rim,
            const PatchMeshBuilder& net)
      : reach_(reach), fill_(fill), rim_(rim), net_(net) {}

  std::vector<KinkLine> make() {
    for (const std::vector<Vec3>& line : reach_.plane().relief->kink_lines(bent)) {
      divide(line);
    }
    return std::move(lines_);
  }

private:
  [[nodiscard]] double size_of(const Vec3& x) const { return fill_.size_at(reach_.distance(x)); }
  /// Within the loops, and not beside one.
  [[nodiscard]] bool free(const Vec3& x) const {
    const base::Vec2 q = reach_.plane().project(x);
    const double away = least_of_size * size_of(x);
    const CrackDistanceField::DistancesFromCrack d = reach_.distance(x);
    return reach_.polygons().contains(q) && reach_.polygons().distance_to_outlines(q) > away &&
           d.front > d.radius + away;
  }

  /// The parts of a line that are free.
  void divide(const std::vector<Vec3>& line) {
    std::size_t begin = 0;
    for (std::size_t i = 0; i <= line.size(); ++i) {
      if (i == line.size() || !free(line[i])) {
        if (i > begin) {
          add(line, begin, i);
        }
        begin = i + 1;
      }
    }
  }

  /// Points from one up to before another.
  void add(const std::vector<Vec3>& line, std::size_t begin, std::size_t end) {
    std::vector<Vec3> points(line.begin() + static_cast<std::ptrdiff_t>(begin),
                             line.begin() + static_cast<std::ptrdiff_t>(end));
    const bool closed = points.size() == line.size() && line.front() == line.back();
    const int from = closed ? -1 : mouth_node(line, begin, -1);
    const int to = closed ? -1 : mouth_node(line, end - 1, 1);
    if (from >= 0) {
      points.insert(points.begin(), net_.local_position(from));
    }
    if (to >= 0) {
      points.push_back(net_.local_position(to));
    }
    const std::vector<double> arc = geometry::arc_lengths(points);
    if (!(arc.back() > size_of(points.front()))) {
      return;
    }
    const auto at = [&](double s) {
      return geometry::position_at_length(arc, s).interpolate(points);
    };
    KinkLine made;
    for (const double s :
         divide_line_by_size(0.0, arc.back(), [&](double s) { return size_of(at(s)); })) {
      made.points.push_back({-1, at(s), size_of(at(s))});
    }
    made.points.front().node = from;
    made.points.back().node = to;
    made.closed = closed;
    if (closed) {
      made.points.pop_back();
    }
    lines_.push_back(std::move(made));
  }

  /// The node of a mouth where a line goes on from one of its points, backwards or forwards.
  [[nodiscard]] int mouth_node(const std::vector<Vec3>& line, std::size_t i, int step) const {
    const double size = size_of(line[i]);
    double way = 0.0;
    for (auto k = static_cast<std::ptrdiff_t>(i);; k += step) {
      const std::ptrdiff_t next = k + step;
      if (next < 0 || next >= static_cast<std::ptrdiff_t>(line.size()) || way > 2.0 * size) {
        return -1;
      }
      const Vec3& a = line[static_cast<std::size_t>(k)];
      const Vec3& b = line[static_cast<std::size_t>(next)];
      for (const int n : rim_) {
        const Vec3 x = net_.local_position(n);
        if (geometry::distance_to_segment(x, a, b) < at_mouth * size) {
          return n;
        }
      }
      way += (b - a).norm();
    }
  }

  const CrackDistanceField& reach_;
  FillSizes fill_;
  const std::vector<int>& rim_;
  const PatchMeshBuilder& net_;
  std::vector<KinkLine> lines_;
};

/// Lines within the loops of a crack, whose nodes are `rim`, away from its tubes; in the frame of
/// the patch.
std::vector<KinkLine> build_kink_lines(const CrackDistanceField& reach, const FillSizes& fill,
                                       const std::vector<int>& rim, const PatchMeshBuilder& net) {
  if (!reach.plane().relief) {
    return {};
  }
  return BendLines(reach, fill, rim, net).make();
}

} // namespace

CrackTriangulation triangulate_crack_area(const CrackDistanceField& reach,
                                          const std::vector<std::vector<int>>& loops,
                                          const FillSizes& fill, PatchMeshBuilder& net) {
  CrackTriangulation surface;
  PlaneRegion region;
  // Layers of elements round a free front are to be alike.
  constexpr double growth_at_free = 0.15;
  const double growth =
      reach.has_tubeless_front() ? growth_at_free / fill.finer : fill.growth_with_distance();
  Grading size(growth);
  for (const std::vector<int>& nodes : loops) {
    std::vector<int> loop;
    for (const int n : nodes) {
      const Vec2 q = reach.plane().project(net.local_position(n));
      loop.push_back(static_cast<int>(region.points.size()));
      region.points.emplace_back(rounded(q.x()), rounded(q.y()));
      surface.nodes.push_back(n);
      const double wanted = fill.size_at(reach.distance(net.local_position(n)));
      size.add_size_source(region.points.back(), rounded(wanted));
    }
    if ((twice_area(region.points, loop) < 0.0) == region.boundaries.empty()) {
      std::reverse(loop.begin(), loop.end());
    }
    region.boundaries.push_back(std::move(loop));
  }
  for (const KinkLine& bend : build_kink_lines(reach, fill, surface.nodes, net)) {
    std::vector<int>& chain = region.embedded.emplace_back();
    for (const KinkLinePoint& point : bend.points) {
      if (point.node >= 0) { // one of a mouth
        const auto at = std::ranges::find(surface.nodes, point.node);
        chain.push_back(static_cast<int>(at - surface.nodes.begin()));
        continue;
      }
      const Vec2 q = reach.plane().project(point.x);
      chain.push_back(static_cast<int>(region.points.size()));
      region.points.emplace_back(rounded(q.x()), rounded(q.y()));
      surface.nodes.push_back(net.add_node_at_local_position(point.x));
      size.add_size_source(region.points.back(), rounded(point.size));
    }
    if (bend.closed) {
      chain.push_back(chain.front());
    }
  }
  const TriangleFill filling = fill_triangles(region, size);
  surface.trouble = filling.trouble;
  for (const Vec2& q : filling.added) {
    surface.nodes.push_back(net.add_node_at_local_position(reach.plane().lift_to_crack(q)));
  }
  for (const std::array<int, 3>& t : filling.cells) {
    PatchTriangle triangle{};
    std::ranges::transform(t, triangle.begin(),
                           [&](int n) { return surface.nodes[static_cast<std::size_t>(n)]; });
    surface.triangles.push_back(triangle);
  }
  return surface;
}

void divide_front_chord_edges(const PlaneBasis& plane, const std::set<int>& front,
                              PatchMeshBuilder& net, CrackTriangulation& surface) {
  using Edge = std::pair<int, int>;
  std::map<Edge, std::vector<std::size_t>> chords;
  // Triangles that come of a division are looked at again: they may have a second chord.
  for (bool more = true; more;) {
    more = false;
    chords.clear();
    for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
      for (std::size_t i = 0; i < 3; ++i) {
        const auto [a, b] = std::minmax(surface.triangles[t][i], surface.triangles[t][(i + 1) % 3]);
        if (front.contains(a) && front.contains(b)) {
          chords[{a, b}].push_back(t);
        }
      }
    }
    for (const auto& [edge, beside] : chords) {
      if (beside.size() < 2) { // an edge of the front
        continue;
      }
      const Vec3 half = 0.5 * (net.local_position(edge.first) + net.local_position(edge.second));
      const int middle = net.add_node_at_local_position(plane.lift_to_crack(plane.project(half)));
      surface.nodes.push_back(middle);
      for (const std::size_t t : beside) {
        PatchTriangle other = surface.triangles[t];
        std::ranges::replace(surface.triangles[t], edge.first, middle);
        std::ranges::replace(other, edge.second, middle);
        surface.triangles.push_back(other);
      }
      more = true;
      break;
    }
  }
}

namespace {

using Tetrahedron = std::array<int, 4>;

/// Corners of the sides of a TET4, and the corner opposite.
constexpr std::array<std::array<std::size_t, 3>, 4> side_corners{
    {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}};
constexpr std::array<std::size_t, 4> opposite{3, 2, 0, 1};

PatchTriangle in_order(PatchTriangle t) {
  std::sort(t.begin(), t.end());
  return t;
}

PatchTriangle corners_of(const Tetrahedron& t, std::size_t side) {
  const auto& c = side_corners[side];
  return {t[c[0]], t[c[1]], t[c[2]]};
}

class Splitter {
public:
  Splitter(const PatchMeshBuilder& net, const std::vector<PatchTriangle>& crack,
           const std::unordered_map<int, int>& lower, std::vector<Tetrahedron>& tetrahedra)
      : net_(net), crack_(crack), lower_(lower), tetrahedra_(tetrahedra) {}

  CrackSidesInFill split() {
    find_sides();
    find_faces();
    // All nodes are told before any is replaced: sides are known by the nodes they have.
    std::vector<std::pair<std::size_t, int>> below;
    for (const auto& [node, around] : around_) {
      tell(node, around, below);
    }
    for (const auto& [t, node] : below) {
      std::replace(tetrahedra_[t].begin(), tetrahedra_[t].end(), node, lower_.at(node));
    }
    return std::move(result_);
  }

private:
  struct Sheet {
    std::vector<TetrahedronFace> sides;
    bool crack = false;
  };

  void find_sides() {
    for (std::size_t t = 0; t < tetrahedra_.size(); ++t) {
      for (const int n : tetrahedra_[t]) {
        if (lower_.contains(n)) {
          around_[n].push_back(t);
        }
      }
      for (std::size_t s = 0; s < 4; ++s) {
        const PatchTriangle corners = corners_of(tetrahedra_[t], s);
        if (std::ranges::any_of(corners, [&](int n) { return lower_.contains(n); })) {
          sheets_[in_order(corners)].sides.push_back({t, static_cast<int>(s)});
        }
      }
    }
  }

  void find_faces() {
    for (const PatchTriangle& triangle : crack_) {
      Sheet& sheet = sheets_[in_order(triangle)];
      sheet.crack = true;
      TetrahedronFace upper;
      TetrahedronFace lower;
      bool both = sheet.sides.size() == 2;
      for (const TetrahedronFace& side : sheet.sides) {
        const Tetrahedron& t = tetrahedra_[side.tetrahedron];
        const int apex = t[opposite[static_cast<std::size_t>(side.side)]];
        (net_.six_times_volume(triangle[0], triangle[1], triangle[2], apex) > 0.0 ? upper : lower) =
            side;
      }
      both = both && upper.tetrahedron != lower.tetrahedron;
      result_.upper.push_back(upper);
      result_.lower.push_back(lower);
      if (!both) {
        result_.trouble = "a crack's face has elements on one side only";
        continue;
      }
      for (const int n : triangle) {
        level_[{n, upper.tetrahedron}] = CrackFaceOfElement::left;
        level_[{n, lower.tetrahedron}] = CrackFaceOfElement::right;
      }
    }
  }

  /// Which of the tetrahedra round a node are below the crack.
  void tell(int node, const std::vector<std::size_t>& around,
            std::vector<std::pair<std::size_t, int>>& below) {
    CrackNodeFan fan(around.size());
    const auto number = [&](std::size_t t) {
      return static_cast<std::size_t>(std::ranges::lower_bound(around, t) - around.begin());
    };
    for (std::size_t i = 0; i < around.size(); ++i) {
      if (const auto at = level_.find({node, around[i]}); at != level_.end()) {
        fan.add_side_on_crack(i, at->second);
      }
      for (std::size_t s = 0; s < 4; ++s) {
        const PatchTriangle corners = corners_of(tetrahedra_[around[i]], s);
        if (std::ranges::find(corners, node) == corners.end()) {
          continue;
        }
        const Sheet& sheet = sheets_.at(in_order(corners));
        for (const TetrahedronFace& side :
             sheet.crack ? std::vector<TetrahedronFace>() : sheet.sides) {
          fan.join_elements(i, number(side.tetrahedron));
        }
      }
    }
    const std::vector<CrackFaceOfElement> sides = fan.crack_face_of_each_element();
    const auto any = [&](CrackFaceOfElement side) { return std::ranges::count(sides, side) > 0; };
    if (any(CrackFaceOfElement::both)) {
      result_.trouble = "the two sides of a crack hang together";
    }
    if (any(CrackFaceOfElement::unknown)) {
      result_.trouble = "an element at a crack lies on neither side of it";
    }
    for (std::size_t i = 0; i < around.size(); ++i) {
      if (sides[i] == CrackFaceOfElement::right) {
        below.emplace_back(around[i], node);
      }
    }
  }

  const PatchMeshBuilder& net_;
  const std::vector<PatchTriangle>& crack_;
  const std::unordered_map<int, int>& lower_;
  std::vector<Tetrahedron>& tetrahedra_;
  std::map<int, std::vector<std::size_t>> around_; ///< [crack node] tetrahedra
  std::map<PatchTriangle, Sheet> sheets_;          ///< sides that have a crack node
  /// Of a node's tetrahedra those with sides on the crack; left is above.
  std::map<std::pair<int, std::size_t>, CrackFaceOfElement> level_;
  CrackSidesInFill result_;
};

} // namespace

CrackSidesInFill open_crack_in_fill(const PatchMeshBuilder& net,
                                    const std::vector<PatchTriangle>& crack,
                                    const std::unordered_map<int, int>& lower,
                                    std::vector<Tetrahedron>& tetrahedra) {
  return Splitter(net, crack, lower, tetrahedra).split();
}

} // namespace spricka::mesh
