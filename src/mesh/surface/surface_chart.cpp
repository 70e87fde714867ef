// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/surface/surface_chart.hpp"

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
  flat_ = fit_plane_frame(patch);
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
SurfaceChart::ChartPreimage SurfaceChart::flat_on(std::size_t face, Vec2 r, const Vec2& u) const {
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
    const Vec2 next = f.clamp(r + step);
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
SurfaceChart::ChartPreimage SurfaceChart::flat_place(std::size_t face, const Vec2& r,
                                                     const Vec2& u) const {
  ChartPreimage best = flat_on(face, r, u);
  if (best.off <= same) {
    return best;
  }
  std::set<std::size_t> near;
  const Vec2 inside = u.cwiseMax(extent_.low).cwiseMin(extent_.high);
  for (const std::size_t f : facets_.boxes_intersecting({inside - room_, inside + room_})) {
    near.insert(net_.facets()[f].face);
  }
  for (const std::size_t other : near) {
    const ChartPreimage there = flat_on(other, surface_.face(other).centre(), u);
    best = there.off < best.off - same ? there : best;
  }
  return best;
}

SurfacePlace SurfaceChart::map_to_surface(const Vec2& u) const {
  const BarycentricPoint spot = find(u);
  const FacetTriangulation::SurfaceFacet& facet = net_.facets()[spot.facet];
  Vec2 r = spot.hat[0] * facet.r[0] + spot.hat[1] * facet.r[1] + spot.hat[2] * facet.r[2];
  r = surface_.face(facet.face).clamp(r);
  if (!flat_) {
    return surface_.place_at_coordinates(facet.face, r);
  }
  const ChartPreimage exact = flat_place(facet.face, r, u);
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

} // namespace spricka::mesh
