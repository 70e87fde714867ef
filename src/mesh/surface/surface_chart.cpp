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
    FlatPlaces places;
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
    const std::optional<FlatPlaces> places = way(patch);
    if (places && all_face_up(net_, *places)) {
      u_ = *places;
      return;
    }
  }
  u_ = straight(mean_frame(patch));
  if (!all_face_up(net_, u_)) {
    trouble_ = {"the surface that the crack's cavity takes away is curved too much to be meshed "
                "anew",
                net_.vertices().front()};
  }
}

void SurfaceChart::sort_facets() {
  Vec2 high = u_.front();
  low_ = high;
  for (const Vec2& u : u_) {
    low_ = low_.cwiseMin(u);
    high = high.cwiseMax(u);
  }
  cells_ =
      std::clamp(static_cast<int>(std::sqrt(static_cast<double>(net_.facets().size()))), 1, 200);
  pitch_ = ((high - low_) / cells_).cwiseMax(1e-300);
  facets_.resize(static_cast<std::size_t>(cells_) * static_cast<std::size_t>(cells_));
  for (std::size_t f = 0; f < net_.facets().size(); ++f) {
    Vec2 from = u_[static_cast<std::size_t>(net_.facets()[f].vertex[0])];
    Vec2 to = from;
    for (const int v : net_.facets()[f].vertex) {
      from = from.cwiseMin(u_[static_cast<std::size_t>(v)]);
      to = to.cwiseMax(u_[static_cast<std::size_t>(v)]);
    }
    const auto cell = [&](const Vec2& u) {
      const Vec2 c = (u - low_).cwiseQuotient(pitch_);
      return std::array{std::clamp(static_cast<int>(c.x()), 0, cells_ - 1),
                        std::clamp(static_cast<int>(c.y()), 0, cells_ - 1)};
    };
    const Vec2 room = Vec2::Constant(1e-7);
    const auto [i0, j0] = cell(from - room);
    const auto [i1, j1] = cell(to + room);
    for (int j = j0; j <= j1; ++j) {
      for (int i = i0; i <= i1; ++i) {
        facets_[static_cast<std::size_t>(j * cells_ + i)].push_back(f);
      }
    }
  }
}

Eigen::Vector3d SurfaceChart::hats(std::size_t facet, const Vec2& u) const {
  const auto& v = net_.facets()[facet].vertex;
  const Vec2& a = u_[static_cast<std::size_t>(v[0])];
  const Vec2& b = u_[static_cast<std::size_t>(v[1])];
  const Vec2& c = u_[static_cast<std::size_t>(v[2])];
  const double area = cross(b - a, c - a);
  const double hb = cross(u - a, c - a) / area;
  const double hc = cross(b - a, u - a) / area;
  return {1.0 - hb - hc, hb, hc};
}

/// The facet that has u, the first of several; beyond the border the nearest, and the nearest place
/// on it.
SurfaceChart::BarycentricPoint SurfaceChart::find(const Vec2& u) const {
  const Vec2 c = (u - low_).cwiseQuotient(pitch_);
  if (c.minCoeff() >= 0.0 && c.maxCoeff() < cells_) {
    const auto cell =
        static_cast<std::size_t>(static_cast<int>(c.y()) * cells_ + static_cast<int>(c.x()));
    for (const std::size_t f : facets_[cell]) {
      const Eigen::Vector3d hat = hats(f, u);
      if (hat.minCoeff() >= -1e-12) {
        return {f, hat};
      }
    }
  }
  BarycentricPoint best;
  double least = std::numeric_limits<double>::max();
  for (std::size_t f = 0; f < net_.facets().size(); ++f) {
    const auto& v = net_.facets()[f].vertex;
    const Eigen::Vector3d inside = hats(f, u);
    if (inside.minCoeff() >= -1e-12) {
      return {f, inside};
    }
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
      const FacetNet::SurfaceFacet& facet = net_.facets()[f];
      const Vec2 b = facet.r[1] - facet.r[0];
      const Vec2 c = facet.r[2] - facet.r[0];
      const double hb = cross(r - facet.r[0], c) / cross(b, c);
      const double hc = cross(b, r - facet.r[0]) / cross(b, c);
      const double least = std::min({hb, hc, 1.0 - hb - hc});
      if (least > most) {
        most = least;
        u = (1.0 - hb - hc) * u_[static_cast<std::size_t>(facet.vertex[0])] +
            hb * u_[static_cast<std::size_t>(facet.vertex[1])] +
            hc * u_[static_cast<std::size_t>(facet.vertex[2])];
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
  const Vec2 c = (u - low_).cwiseQuotient(pitch_);
  std::set<std::size_t> near;
  for (int j = -1; j <= 1; ++j) {
    for (int i = -1; i <= 1; ++i) {
      const int column = std::clamp(static_cast<int>(c.x()) + i, 0, cells_ - 1);
      const int row = std::clamp(static_cast<int>(c.y()) + j, 0, cells_ - 1);
      for (const std::size_t f : facets_[static_cast<std::size_t>(row * cells_ + column)]) {
        near.insert(net_.facets()[f].face);
      }
    }
  }
  for (const std::size_t other : near) {
    const bool triangle = surface_.face(other).corners() == 3;
    const Vec2 centre = triangle ? Vec2(1.0 / 3.0, 1.0 / 3.0) : Vec2(0.0, 0.0);
    const ChartPreimage there = flat_on(other, centre, u);
    best = there.off < best.off - same ? there : best;
  }
  return best;
}

SurfacePlace SurfaceChart::map_to_surface(const Vec2& u) const {
  const BarycentricPoint spot = find(u);
  const FacetNet::SurfaceFacet& facet = net_.facets()[spot.facet];
  Vec2 r = spot.hat[0] * facet.r[0] + spot.hat[1] * facet.r[1] + spot.hat[2] * facet.r[2];
  r = surface_.face(facet.face).clamp(r);
  if (!flat_) {
    return surface_.place_on_face(facet.face, r);
  }
  const ChartPreimage exact = flat_place(facet.face, r, u);
  return surface_.place_on_face(exact.face, exact.r);
}

SurfacePlace SurfaceChart::midpoint(const SurfacePlace& a, const SurfacePlace& b, const Vec2& ua,
                                    const Vec2& ub) const {
  return map_to_surface(flat_ ? (*flat_)(0.5 * (a.x + b.x)) : Vec2(0.5 * (ua + ub)));
}

double SurfaceChart::parameter_scale(const Vec2& u) const {
  const FacetNet::SurfaceFacet& facet = net_.facets()[find(u).facet];
  const auto at = [&](std::size_t k) { return static_cast<std::size_t>(facet.vertex[k]); };
  const Vec3 b = net_.vertices()[at(1)] - net_.vertices()[at(0)];
  const Vec3 c = net_.vertices()[at(2)] - net_.vertices()[at(0)];
  const double area = std::sqrt(b.squaredNorm() * c.squaredNorm() - b.dot(c) * b.dot(c));
  const double flat = cross(u_[at(1)] - u_[at(0)], u_[at(2)] - u_[at(0)]);
  return std::sqrt(flat / area);
}

} // namespace spricka::mesh
