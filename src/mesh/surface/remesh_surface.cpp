// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/surface/remesh_surface.hpp"

#include "geometry/polyline.hpp"
#include "mesh/link/fill.hpp"
#include "mesh/plane.hpp"
#include "mesh/surface/new_surface.hpp"
#include "mesh/surface/surface_chart.hpp"
#include "mesh/surface/surface_region.hpp"

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>

namespace spricka::mesh {

using base::NodeId;
using base::Vec2;
using base::Vec3;

namespace {

constexpr double on_region = 1e-6; // of the crack's length: how far a cap's corner may lie off

/// Feature edges beside a cap, or a mouth's end, are divided no coarser than they are far from
/// it.
SizeFunction size_near_caps(const SurfaceRegion& region) {
  return [&region](const Vec3& x) {
    const double wanted = region.size(x);
    double away = wanted;
    for (const std::vector<Vec3>& cap : region.caps) {
      away = std::min(away, geometry::distance_to_outline(x, cap));
    }
    for (const SurfaceMouth& mouth : region.mouths) {
      const auto& corners = mouth.line.corners;
      for (const std::size_t end : {0U, 1U}) {
        if (!mouth.closed && mouth.end[end].cap < 0) {
          const TracePoint& corner = end == 0 ? corners.front() : corners.back();
          away = std::min(away, (x - corner.place.x).norm());
        }
      }
    }
    return std::max(away, 0.1 * wanted);
  };
}

/// The new surface while it is made: its edges are found by their points, and the first failure is
/// its trouble.
class RemeshedSurfaceBuilder {
public:
  void fail(const std::string& why, const Vec3& at) {
    if (!surface.trouble) {
      surface.trouble = {why, at};
    }
  }

  int add_point(const SurfacePlace& place) {
    surface.points.push_back({place, NodeId()});
    return static_cast<int>(surface.points.size()) - 1;
  }
  /// An edge of the surface is found by its points from now on, the lower first.
  void index_edge(std::size_t e) {
    auto& [a, b] = surface.edges[e].points;
    if (b < a) {
      std::swap(a, b);
    }
    known_.try_emplace({a, b}, static_cast<int>(e));
  }
  void add_edge(int a, int b, RemeshedEdgeKind kind, const SurfacePlace& mid) {
    surface.edges.push_back({{a, b}, kind, mid, NodeId()});
    index_edge(surface.edges.size() - 1);
  }

  [[nodiscard]] const SurfacePlace& place(int point) const {
    return surface.points[static_cast<std::size_t>(point)].place;
  }

  /// What the edge between two points is, for messages.
  [[nodiscard]] std::string edge_name(int one, int two) const {
    const auto at = known_.find(std::minmax(one, two));
    static const std::map<RemeshedEdgeKind, const char*> names{
        {RemeshedEdgeKind::rim, "the rim of the cavity"},
        {RemeshedEdgeKind::feature, "an edge of the body"},
        {RemeshedEdgeKind::outline, "an end of the tube"},
        {RemeshedEdgeKind::mouth, "the crack's mouth"}};
    const auto name = at == known_.end()
                          ? names.end()
                          : names.find(surface.edges[static_cast<std::size_t>(at->second)].kind);
    return name == names.end() ? "a line" : name->second;
  }

  /// The triangles that fill a patch, inner points and edges with them.
  void add_triangles(const SurfaceChart& chart, const ChartOutline& outline,
                     const TriangleFill& filling) {
    std::vector<Vec2> u = outline.region.points;
    std::vector<int> point = outline.point;
    for (const Vec2& p : filling.added) {
      u.emplace_back(rounded(p.x()), rounded(p.y()));
      point.push_back(add_point(chart.map_to_surface(u.back())));
    }
    for (const std::array<int, 3>& corners : filling.cells) {
      RemeshedTriangle triangle;
      Vec2 middle = Vec2::Zero();
      for (std::size_t k = 0; k < 3; ++k) {
        const auto i = static_cast<std::size_t>(corners[k]);
        const auto j = static_cast<std::size_t>(corners[(k + 1) % 3]);
        const auto [a, b] = std::minmax(point[i], point[j]);
        if (!known_.contains({a, b})) {
          add_edge(a, b, RemeshedEdgeKind::inner,
                   chart.midpoint(place(point[i]), place(point[j]), u[i], u[j]));
        }
        triangle.points[k] = point[i];
        triangle.edges[k] = known_.at({a, b});
        middle += u[i] / 3.0;
      }
      triangle.face = chart.map_to_surface(middle).face;
      surface.triangles.push_back(triangle);
    }
  }

  RemeshedSurface surface;

private:
  std::map<std::pair<int, int>, int> known_; ///< edges by their points
};

class Remesher {
public:
  Remesher(const SurfaceGeometry& surface, const SurfaceRegion& region)
      : surface_(surface), region_(region), patches_(surface, region.faces) {}

  RemeshedSurface run() {
    made_.surface.trouble = patches_.failure();
    take_caps();
    take_mouths();
    if (!made_.surface.trouble) {
      lines_.emplace(surface_, patches_, size_near_caps(region_), crossings_, made_.surface);
      for (std::size_t e = 0; e < made_.surface.edges.size(); ++e) {
        made_.index_edge(e);
      }
    }
    for (std::size_t p = 0; p < patches_.count() && !made_.surface.trouble; ++p) {
      fill_patch(p);
    }
    if (!made_.surface.trouble) {
      made_.surface.trouble = find_remeshed_surface_fault(surface_, made_.surface);
    }
    if (made_.surface.trouble) {
      return {{}, {}, {}, {}, {}, made_.surface.trouble};
    }
    return std::move(made_.surface);
  }

private:
  void take_caps() {
    for (const std::vector<Vec3>& cap : region_.caps) {
      std::vector<int> points;
      for (const Vec3& x : cap) {
        const SurfacePlace near = surface_.nearest_place(x, patches_.all_faces());
        if (near.face == nowhere || (near.x - x).norm() > on_region * region_.plane.length) {
          made_.fail(
              "an end of the tube round the crack's front does not lie on the surface that the "
              "cavity takes away",
              x);
          return;
        }
        points.push_back(made_.add_point(near));
        if (patches_.patch_containing(near.face) !=
            patches_.patch_containing(made_.place(points.front()).face)) {
          made_.fail("an end of the tube round the crack's front covers an edge of the body", x);
        }
      }
      made_.surface.caps.push_back(points);
    }
  }

  void take_mouths() {
    for (const SurfaceMouth& mouth : region_.mouths) {
      if (made_.surface.trouble) {
        return;
      }
      std::vector<int> points;
      const auto& corners = mouth.line.corners;
      for (std::size_t i = 0; i < corners.size(); ++i) {
        const bool end = i == 0 || i + 1 == corners.size();
        const MouthEnd& at = mouth.end[i == 0 ? 0 : 1];
        if (mouth.closed && i + 1 == corners.size()) {
          points.push_back(points.front());
          continue;
        }
        if (end && at.cap >= 0) {
          points.push_back(made_.surface.caps[static_cast<std::size_t>(at.cap)]
                                             [static_cast<std::size_t>(at.corner)]);
          continue;
        }
        points.push_back(made_.add_point(corners[i].place));
        if (corners[i].edge != nowhere) {
          cross_edge(corners[i], points.back());
        }
      }
      for (std::size_t i = 0; i + 1 < points.size(); ++i) {
        if (patches_.patch_containing(mouth.line.mids[i].face) == nowhere) {
          made_.fail("the crack's mouth leaves the surface that the cavity takes away",
                     mouth.line.mids[i].x);
        }
        made_.add_edge(points[i], points[i + 1], RemeshedEdgeKind::mouth, mouth.line.mids[i]);
      }
      made_.surface.mouths.push_back(points);
    }
  }

  void cross_edge(const TracePoint& corner, int point) {
    const SurfaceEdge& edge = surface_.edges()[corner.edge];
    if (!std::ranges::binary_search(patches_.feature_edges(), corner.edge)) {
      // The line may have been followed over borders of sets that are no edges here.
      if (edge.faces[0] != nowhere && edge.faces[1] != nowhere &&
          patches_.patch_containing(edge.faces[0]) != nowhere &&
          patches_.patch_containing(edge.faces[0]) == patches_.patch_containing(edge.faces[1])) {
        return;
      }
      made_.fail("the crack's mouth leaves the surface that the cavity takes away", corner.place.x);
    }
    if (std::abs(corner.t) >= 1.0 - coordinate_tolerance) {
      const NodeId node = edge.ends[corner.t < 0.0 ? 0 : 1];
      for (const std::size_t e : patches_.rim_edges()) {
        if (std::ranges::count(surface_.edges()[e].ends, node) > 0) {
          made_.fail("the crack's mouth runs through the rim of the cavity", corner.place.x);
        }
      }
    }
    crossings_[corner.edge].push_back({corner.t, point});
  }

  /// The points on one side of a patch's border, but for its end.
  void go_along(const PatchBorderSide& side, const SurfaceChart& chart, ChartOutline& outline,
                std::vector<int>& loop) {
    const geometry::ElementSide& face = surface_.face(side.face);
    const SurfaceEdge& edge = surface_.edges()[side.edge];
    const auto take = [&](int point, double t) {
      loop.push_back(outline.find_or_add_region_point(
          point, chart.at(side.face, face.edge_coordinates(side.side, t))));
    };
    const NodeId from = face.nodes[static_cast<std::size_t>(side.side)];
    if (lines_->point_at_node(from) >= 0) {
      take(lines_->point_at_node(from), -1.0);
    }
    const bool along = from == edge.ends[0];
    const std::vector<FeatureEdgePoint>& points = lines_->points_on_edge(side.edge);
    for (std::size_t i = 0; i < points.size(); ++i) {
      const FeatureEdgePoint& point = along ? points[i] : points[points.size() - 1 - i];
      take(point.point, along ? point.t : -point.t);
    }
  }

  void fill_patch(std::size_t patch) {
    const SurfaceChart chart(surface_, patches_.faces(patch), region_.plane);
    if (chart.failure()) {
      made_.fail(chart.failure().why, chart.failure().at);
      return;
    }
    ChartOutline outline;
    for (const std::vector<PatchBorderSide>& sides : patches_.border_loops(patch)) {
      std::vector<int> loop;
      for (const PatchBorderSide& side : sides) {
        go_along(side, chart, outline, loop);
      }
      outline.region.boundaries.push_back(loop);
    }
    const std::size_t first_cap = outline.region.boundaries.size();
    add_caps(patch, chart, outline);
    embed_mouths(patch, chart, outline);
    embed_creases(patch, chart, outline);
    if (const auto clash = find_line_intersection(outline.region, first_cap)) {
      tell(*clash, outline);
      return;
    }
    const TriangleFill filling = fill_triangles(
        outline.region, chart_grading(chart, outline.region, region_.size, region_.growth));
    if (!filling.trouble.empty()) {
      made_.fail("the surface that the crack's cavity takes away cannot be meshed anew: " +
                     filling.trouble,
                 made_.place(outline.point.front()).x);
      return;
    }
    made_.add_triangles(chart, outline, filling);
  }

  void add_caps(std::size_t patch, const SurfaceChart& chart, ChartOutline& outline) {
    for (const std::vector<int>& cap : made_.surface.caps) {
      if (patches_.patch_containing(made_.place(cap.front()).face) != patch) {
        continue;
      }
      std::vector<int> loop;
      loop.reserve(cap.size());
      for (const int point : cap) {
        loop.push_back(outline.find_or_add_region_point(
            point, chart.at(made_.place(point).face, made_.place(point).r)));
      }
      const auto u = [&](std::size_t i) -> const Vec2& {
        return outline.region.points[static_cast<std::size_t>(loop[i % loop.size()])];
      };
      for (std::size_t i = 0; i < loop.size(); ++i) {
        const auto [a, b] = std::pair(cap[i], cap[(i + 1) % cap.size()]);
        made_.add_edge(a, b, RemeshedEdgeKind::outline,
                       chart.midpoint(made_.place(a), made_.place(b), u(i), u(i + 1)));
      }
      // the patch lies outside of it, and on the left
      if (twice_area(outline.region.points, loop) > 0.0) {
        std::ranges::reverse(loop);
      }
      outline.region.boundaries.push_back(loop);
    }
  }

  /// Where a point of a feature edge lies on the faces of a patch.
  [[nodiscard]] Vec2 from_patch(std::size_t patch, std::size_t e, double t,
                                const SurfaceChart& chart) const {
    const SurfaceEdge& edge = surface_.edges()[e];
    const std::size_t way = patches_.patch_containing(edge.faces[0]) == patch ? 0 : 1;
    const std::size_t f = edge.faces[way];
    return chart.at(f, surface_.face(f).edge_coordinates(edge.side[way], way == 0 ? t : -t));
  }

  void embed_mouths(std::size_t patch, const SurfaceChart& chart, ChartOutline& outline) {
    for (std::size_t m = 0; m < region_.mouths.size(); ++m) {
      const DividedTrace& line = region_.mouths[m].line;
      std::vector<int> chain;
      for (std::size_t i = 0; i < line.mids.size(); ++i) {
        const bool here = patches_.patch_containing(line.mids[i].face) == patch;
        for (const std::size_t k : {i, i + 1}) {
          if (here && (k > i || chain.empty())) {
            chain.push_back(outline.find_or_add_region_point(made_.surface.mouths[m][k],
                                                             mouth_at(patch, line, {m, k}, chart)));
          }
        }
        if (!chain.empty() && (!here || i + 1 == line.mids.size())) {
          outline.region.embedded.push_back(std::exchange(chain, {}));
        }
      }
    }
  }

  [[nodiscard]] Vec2 mouth_at(std::size_t patch, const DividedTrace& line,
                              std::pair<std::size_t, std::size_t> index,
                              const SurfaceChart& chart) const {
    const TracePoint& corner = line.corners[index.second];
    // In a corner of the body the line comes to a third patch, which does not have the edge.
    const auto has = [&](std::size_t face) { return patches_.patch_containing(face) == patch; };
    if (corner.edge != nowhere && std::ranges::any_of(surface_.edges()[corner.edge].faces, has)) {
      return from_patch(patch, corner.edge, corner.t, chart);
    }
    return point_at(patch, made_.surface.mouths[index.first][index.second], chart);
  }

  /// A point in the chart of a patch: where it lies on the patch, else the nearest place of it.
  [[nodiscard]] Vec2 point_at(std::size_t patch, int point, const SurfaceChart& chart) const {
    const SurfacePlace& own = made_.place(point);
    const SurfacePlace near = patches_.patch_containing(own.face) == patch
                                  ? own
                                  : surface_.nearest_place(own.x, patches_.faces(patch));
    return chart.at(near.face, near.r);
  }

  /// Feature edges that end within the patch, as they are divided.
  void embed_creases(std::size_t patch, const SurfaceChart& chart, ChartOutline& outline) {
    for (const RemeshedEdge& made : made_.surface.edges) {
      if (made.kind != RemeshedEdgeKind::feature) {
        continue;
      }
      const SurfaceEdge& edge = surface_.edges()[made.host_edge];
      if (patches_.patch_containing(edge.faces[0]) != patch ||
          patches_.patch_containing(edge.faces[1]) != patch) {
        continue;
      }
      std::vector<int>& chain = outline.region.embedded.emplace_back();
      for (const int point : made.points) {
        chain.push_back(outline.find_or_add_region_point(point, point_at(patch, point, chart)));
      }
    }
  }

  [[nodiscard]] std::string line_name(std::pair<int, int> line, const ChartOutline& outline) const {
    return made_.edge_name(outline.point[static_cast<std::size_t>(line.first)],
                           outline.point[static_cast<std::size_t>(line.second)]);
  }

  void tell(const LineIntersection& clash, const ChartOutline& outline) {
    const Vec3& x = made_.place(outline.point[static_cast<std::size_t>(clash.one.first)]).x;
    if (clash.outside) {
      made_.fail("an end of the tube lies beside the surface that the cavity takes away", x);
    } else {
      made_.fail("on the body's surface " + line_name(clash.one, outline) + " meets " +
                     line_name(clash.two, outline),
                 x);
    }
  }

  const SurfaceGeometry& surface_;
  const SurfaceRegion& region_;
  SmoothSurfacePatches patches_;
  RemeshedSurfaceBuilder made_;
  std::map<std::size_t, std::vector<FeatureEdgePoint>> crossings_;
  std::optional<FeatureLines> lines_;
};

} // namespace

RemeshedSurface remesh_surface(const SurfaceGeometry& surface, const SurfaceRegion& region) {
  return Remesher(surface, region).run();
}

} // namespace spricka::mesh
