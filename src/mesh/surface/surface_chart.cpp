// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/surface/surface_chart.hpp"

#include "geometry/box.hpp"
#include "geometry/polyline.hpp"
#include "mesh/plane.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <set>

#include <Eigen/LU>

namespace spricka::mesh {

using base::Vec2;
using base::Vec3;

SurfaceChart::SurfaceChart(const SurfaceGeometry& surface, const std::vector<std::size_t>& faces,
                           const CrackReferencePlane& plane)
    : surface_(surface), faces_(faces), net_(surface, faces_) {
  flatten_onto_plane(plane);
  if (!trouble_) {
    sort_facets();
  }
}

void SurfaceChart::flatten_onto_plane(const CrackReferencePlane& plane) {
  const ChartPatch patch{surface_, faces_, net_, plane};
  const auto straight = [&](const ChartPlaneFrame& frame) {
    FlattenedVertexCoordinates places;
    for (const Vec3& x : net_.vertices()) {
      places.push_back(frame(x));
    }
    return places;
  };
  flat_ = frame_of_plane_patch(patch);
  if (flat_) {
    u_ = straight(*flat_);
    return;
  }
  for (const auto& way : {unroll_cylinder, conformal_map}) {
    const std::optional<FlattenedVertexCoordinates> places = way(patch);
    if (places && has_no_inverted_facets(net_, *places)) {
      u_ = *places;
      return;
    }
  }
  u_ = straight(mean_plane_frame(patch));
  if (!has_no_inverted_facets(net_, u_)) {
    trouble_ = {"the surface that the crack's cavity takes away is curved too much to be meshed "
                "anew",
                net_.vertices().front()};
  }
}

void SurfaceChart::sort_facets() {
  std::vector<geometry::Box<2>> boxes;
  for (const FacetTriangulation::SurfaceFacet& facet : net_.facets()) {
    const auto u = [&](std::size_t k) { return u_[static_cast<std::size_t>(facet.vertex[k])]; };
    boxes.push_back(geometry::Box<2>::around(std::array{u(0), u(1), u(2)}).grown(1e-7));
  }
  facets_ = geometry::BoxTree<2>(boxes);
  extent_ = geometry::Box<2>::around(u_);
  room_ = 2.0 * (extent_.high - extent_.low) / std::sqrt(static_cast<double>(boxes.size()));
}

namespace {

/// Barycentric coordinates of a place in the plane of a triangle.
Eigen::Vector3d barycentric_coordinates(const Vec2& p, const Vec2& a, const Vec2& b,
                                        const Vec2& c) {
  const double area = cross(b - a, c - a);
  const double hb = cross(p - a, c - a) / area;
  const double hc = cross(b - a, p - a) / area;
  return {1.0 - hb - hc, hb, hc};
}

} // namespace

Eigen::Vector3d SurfaceChart::hats(std::size_t facet, const Vec2& u) const {
  const auto& v = net_.facets()[facet].vertex;
  return barycentric_coordinates(u, u_[static_cast<std::size_t>(v[0])],
                                 u_[static_cast<std::size_t>(v[1])],
                                 u_[static_cast<std::size_t>(v[2])]);
}

/// The facet that has u, the first of several; beyond the border the nearest, and the nearest place
/// on it.
SurfaceChart::BarycentricPoint SurfaceChart::find(const Vec2& u) const {
  for (const std::size_t f : facets_.boxes_containing(u)) {
    const Eigen::Vector3d hat = hats(f, u);
    if (hat.minCoeff() >= -1e-12) {
      return {f, hat};
    }
  }
  BarycentricPoint best;
  double least = std::numeric_limits<double>::max();
  for (std::size_t f = 0; f < net_.facets().size(); ++f) {
    const auto& v = net_.facets()[f].vertex;
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec2& a = u_[static_cast<std::size_t>(v[k])];
      const Vec2& b = u_[static_cast<std::size_t>(v[(k + 1) % 3])];
      const auto [t, away] = geometry::nearest_point(u, a, b);
      if (away < least) {
        least = away;
        best = {f, Eigen::Vector3d::Zero()};
        best.hat[static_cast<Eigen::Index>(k)] = 1.0 - t;
        best.hat[static_cast<Eigen::Index>((k + 1) % 3)] = t;
      }
    }
  }
  return best;
}

Vec2 SurfaceChart::at(std::size_t face, const Vec2& r) const {
  Vec2 u = Vec2::Zero();
  if (flat_) {
    u = (*flat_)(surface_.face(face).position(r));
  } else {
    const auto i =
        static_cast<std::size_t>(std::ranges::lower_bound(faces_, face) - faces_.begin());
    double most = -std::numeric_limits<double>::max();
    for (std::size_t f = net_.first_facet(i); f < net_.first_facet(i + 1); ++f) {
      const FacetTriangulation::SurfaceFacet& facet = net_.facets()[f];
      const Eigen::Vector3d hat = barycentric_coordinates(r, facet.r[0], facet.r[1], facet.r[2]);
      const double least = std::min({hat[1], hat[2], hat[0]});
      if (least > most) {
        most = least;
        u = hat[0] * u_[static_cast<std::size_t>(facet.vertex[0])] +
            hat[1] * u_[static_cast<std::size_t>(facet.vertex[1])] +
            hat[2] * u_[static_cast<std::size_t>(facet.vertex[2])];
      }
    }
  }
  return {rounded(u.x()), rounded(u.y())};
}

/// The place of a plane face with exactly these parameters, or the nearest that steps lead to.
SurfaceChart::FacePointAtParameters SurfaceChart::flat_on(std::size_t face, Vec2 r,
                                                          const Vec2& u) const {
  const geometry::ElementSide& f = surface_.face(face);
  for (int i = 0; i < 20; ++i) {
    const geometry::SidePoint p = f.point(r);
    Eigen::Matrix2d J;
    J << flat_->e1.dot(p.tangents.col(0)), flat_->e1.dot(p.tangents.col(1)),
        flat_->e2.dot(p.tangents.col(0)), flat_->e2.dot(p.tangents.col(1));
    const Vec2 step = flat_->length * (J.inverse() * (u - (*flat_)(p.x)));
    if (!step.allFinite()) {
      break;
    }
    const Vec2 next = f.clamp_to_side(r + step);
    const double moved = (next - r).norm();
    r = next;
    if (moved < 1e-15) {
      break;
    }
  }
  return {face, r, (u - (*flat_)(f.position(r))).norm()};
}

/// The same on whichever face has it: edges between plane faces may be curved, so that the facet
/// tells only whereabouts to look.
SurfaceChart::FacePointAtParameters SurfaceChart::flat_place(std::size_t face, const Vec2& r,
                                                             const Vec2& u) const {
  FacePointAtParameters best = flat_on(face, r, u);
  if (best.off <= coordinate_tolerance) {
    return best;
  }
  std::set<std::size_t> near;
  const Vec2 inside = u.cwiseMax(extent_.low).cwiseMin(extent_.high);
  for (const std::size_t f : facets_.boxes_intersecting({inside - room_, inside + room_})) {
    near.insert(net_.facets()[f].face);
  }
  for (const std::size_t other : near) {
    const FacePointAtParameters there = flat_on(other, surface_.face(other).domain_centre(), u);
    best = there.off < best.off - coordinate_tolerance ? there : best;
  }
  return best;
}

SurfacePlace SurfaceChart::map_to_surface(const Vec2& u) const {
  const BarycentricPoint spot = find(u);
  const FacetTriangulation::SurfaceFacet& facet = net_.facets()[spot.facet];
  Vec2 r = spot.hat[0] * facet.r[0] + spot.hat[1] * facet.r[1] + spot.hat[2] * facet.r[2];
  r = surface_.face(facet.face).clamp_to_side(r);
  if (!flat_) {
    return surface_.place_at_coordinates(facet.face, r);
  }
  const FacePointAtParameters exact = flat_place(facet.face, r, u);
  return surface_.place_at_coordinates(exact.face, exact.r);
}

SurfacePlace SurfaceChart::midpoint(const SurfacePlace& a, const SurfacePlace& b, const Vec2& ua,
                                    const Vec2& ub) const {
  return map_to_surface(flat_ ? (*flat_)(0.5 * (a.x + b.x)) : Vec2(0.5 * (ua + ub)));
}

double SurfaceChart::parameter_scale(const Vec2& u) const {
  const FacetTriangulation::SurfaceFacet& facet = net_.facets()[find(u).facet];
  const auto at = [&](std::size_t k) { return static_cast<std::size_t>(facet.vertex[k]); };
  const Vec3 b = net_.vertices()[at(1)] - net_.vertices()[at(0)];
  const Vec3 c = net_.vertices()[at(2)] - net_.vertices()[at(0)];
  const double area = std::sqrt(b.squaredNorm() * c.squaredNorm() - b.dot(c) * b.dot(c));
  const double flat = cross(u_[at(1)] - u_[at(0)], u_[at(2)] - u_[at(0)]);
  return std::sqrt(flat / area);
}

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
  if (std::max(a.x(), b.x()) + coordinate_tolerance < std::min(c.x(), d.x()) ||
      std::max(c.x(), d.x()) + coordinate_tolerance < std::min(a.x(), b.x()) ||
      std::max(a.y(), b.y()) + coordinate_tolerance < std::min(c.y(), d.y()) ||
      std::max(c.y(), d.y()) + coordinate_tolerance < std::min(a.y(), b.y())) {
    return false;
  }
  const bool first = one.first == two.first || one.first == two.second;
  const bool second = one.second == two.first || one.second == two.second;
  if (first && second) {
    return true; // the same line twice
  }
  if (!first && !second) {
    return distance(a, b, c, d) <= coordinate_tolerance;
  }
  const Vec2& common = first ? a : b;
  const Vec2& p = first ? b : a;
  const bool to_first = two.first == (first ? one.first : one.second);
  const Vec2& q = to_first ? d : c;
  return geometry::distance_to_segment(p, common, q) <= coordinate_tolerance ||
         geometry::distance_to_segment(q, common, p) <= coordinate_tolerance;
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
      in = in != (other != k &&
                  is_inside_polygon(point_of(region, region.boundaries[k].front()), polygon));
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
