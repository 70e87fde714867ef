// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/surface/piece_outline.hpp"

#include "geometry/box.hpp"
#include "geometry/polyline.hpp"
#include "mesh/plane.hpp"

#include <algorithm>
#include <limits>

namespace spricka::mesh {

using base::Vec2;

namespace {

using Line = std::pair<int, int>;

const Vec2& point_of(const PlaneRegion& region, int i) {
  return region.points[static_cast<std::size_t>(i)];
}

std::vector<Line> lines_of(const PlaneRegion& region) {
  std::vector<Line> lines;
  for (const std::vector<int>& loop : region.boundaries) {
    for (std::size_t i = 0; i < loop.size(); ++i) {
      lines.emplace_back(loop[i], loop[(i + 1) % loop.size()]);
    }
  }
  for (const std::vector<int>& chain : region.embedded) {
    for (std::size_t i = 0; i + 1 < chain.size(); ++i) {
      lines.emplace_back(chain[i], chain[i + 1]);
    }
  }
  return lines;
}

/// Whether two lines meet other than in a common end.
bool clash(const PlaneRegion& region, const Line& one, const Line& two) {
  const Vec2& a = point_of(region, one.first);
  const Vec2& b = point_of(region, one.second);
  const Vec2& c = point_of(region, two.first);
  const Vec2& d = point_of(region, two.second);
  if (std::max(a.x(), b.x()) + same < std::min(c.x(), d.x()) ||
      std::max(c.x(), d.x()) + same < std::min(a.x(), b.x()) ||
      std::max(a.y(), b.y()) + same < std::min(c.y(), d.y()) ||
      std::max(c.y(), d.y()) + same < std::min(a.y(), b.y())) {
    return false;
  }
  const bool first = one.first == two.first || one.first == two.second;
  const bool second = one.second == two.first || one.second == two.second;
  if (first && second) {
    return true; // the same line twice
  }
  if (!first && !second) {
    return distance(a, b, c, d) <= same;
  }
  const Vec2& common = first ? a : b;
  const Vec2& p = first ? b : a;
  const bool to_first = two.first == (first ? one.first : one.second);
  const Vec2& q = to_first ? d : c;
  return geometry::distance_to_segment(p, common, q) <= same ||
         geometry::distance_to_segment(q, common, p) <= same;
}

/// Wanted sizes where the lines' own do not yet ask for less, in cells that are halved until they
/// are smaller than the size.
class WantedSizes {
public:
  WantedSizes(const SurfaceChart& chart, const PlaneRegion& region, const SizeFunction& size,
              Grading& grading)
      : chart_(chart), region_(region), size_(size), grading_(grading) {}

  void add() {
    const auto [low, high] = geometry::Box<2>::around(region_.points);
    std::vector<Vec2> cells{0.5 * (low + high)};
    double half = 0.5 * (high - low).maxCoeff();
    for (int level = 0; level < most_levels && !cells.empty(); ++level, half *= 0.5) {
      std::vector<Vec2> finer;
      for (const Vec2& cell : cells) {
        const double size = at(cell, half);
        if (2.0 * half > size && finer.size() < most_cells) {
          for (const Vec2& way : {Vec2(-1, -1), Vec2(1, -1), Vec2(-1, 1), Vec2(1, 1)}) {
            finer.emplace_back(cell + 0.5 * half * way);
          }
        }
      }
      cells = std::move(finer);
    }
  }

private:
  static constexpr int most_levels = 14;
  static constexpr std::size_t most_cells = 20000;
  static constexpr double coarser = 1.1; // by so much the grading may be off

  /// The size in a cell, in parameters; far outside, where nothing is to be divided further,
  /// endless.
  double at(const Vec2& u, double half) {
    bool within = false;
    double near = std::numeric_limits<double>::max();
    for (const std::vector<int>& loop : region_.boundaries) {
      for (std::size_t i = 0; i < loop.size(); ++i) {
        const Vec2& a = point_of(region_, loop[i]);
        const Vec2& b = point_of(region_, loop[(i + 1) % loop.size()]);
        near = std::min(near, geometry::distance_to_segment(u, a, b));
        if ((a.y() > u.y()) != (b.y() > u.y()) &&
            u.x() < a.x() + (b.x() - a.x()) * (u.y() - a.y()) / (b.y() - a.y())) {
          within = !within;
        }
      }
    }
    if (!within) {
      return near > 1.5 * half ? std::numeric_limits<double>::max() : grading_(u);
    }
    const double size = rounded(size_(chart_.map_to_surface(u).x) * chart_.parameter_scale(u));
    if (grading_(u) > coarser * size) {
      grading_.add_size_source(u, size);
    }
    return size;
  }

  const SurfaceChart& chart_;
  const PlaneRegion& region_;
  const SizeFunction& size_;
  Grading& grading_;
};

} // namespace

int ChartOutline::find_or_add_region_point(int of_surface, const Vec2& u) {
  const auto [at, fresh] = known_.try_emplace(of_surface, static_cast<int>(point.size()));
  if (fresh) {
    point.push_back(of_surface);
    region.points.push_back(u);
  }
  return at->second;
}

std::optional<LineIntersection> find_line_intersection(const PlaneRegion& region,
                                                       std::size_t first_cap) {
  const std::vector<Line> lines = lines_of(region);
  for (std::size_t i = 0; i < lines.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      if (clash(region, lines[i], lines[j])) {
        return LineIntersection{lines[i], lines[j], false};
      }
    }
  }
  for (std::size_t k = first_cap; k < region.boundaries.size(); ++k) {
    bool in = false;
    for (std::size_t other = 0; other < region.boundaries.size(); ++other) {
      std::vector<Vec2> polygon;
      for (const int i : region.boundaries[other]) {
        polygon.push_back(point_of(region, i));
      }
      in = in != (other != k && is_inside(point_of(region, region.boundaries[k].front()), polygon));
    }
    if (!in) {
      const Line at{region.boundaries[k][0], region.boundaries[k][1]};
      return LineIntersection{at, at, true};
    }
  }
  return std::nullopt;
}

Grading chart_grading(const SurfaceChart& chart, const PlaneRegion& region,
                      const SizeFunction& size, double growth) {
  Grading grading(growth);
  for (const auto& [a, b] : lines_of(region)) {
    const Vec2& p = point_of(region, a);
    const Vec2& q = point_of(region, b);
    const Vec2 middle = 0.5 * (p + q);
    const double wanted =
        rounded(size(chart.map_to_surface(middle).x) * chart.parameter_scale(middle));
    grading.add_size_source(middle, std::min((q - p).norm(), wanted));
  }
  WantedSizes(chart, region, size, grading).add();
  return grading;
}

} // namespace spricka::mesh
