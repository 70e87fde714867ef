// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/body_boundary.hpp"

#include "base/by_dimension.hpp"
#include "geometry/polyline.hpp"
#include "geometry/triangle.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <tuple>

#include <Eigen/Geometry>

namespace spricka::geometry {

using base::Vec3;

namespace {

constexpr double sharp_turn = 0.6; // turns of more belong to the shape, not to its facets [rad]

double angle_between(const Vec3& a, const Vec3& b) {
  return std::atan2(a.cross(b).norm(), a.dot(b));
}

NearestTrianglePoint nearest_on_segment(const Vec3& x, const Vec3& a, const Vec3& b) {
  const double part = nearest_segment_parameter<3>(x, a, b);
  return {a + part * (b - a), part <= 0.0 ? 0 : (part >= 1.0 ? 1 : -1), -1};
}

} // namespace

/// What facets are: segments of the plane, or triangles.
struct BodyBoundary::FacetKind {
  using Corners = std::array<Vec3, 3>;

  std::size_t corners;
  std::size_t ridge_corners; ///< of what two facets have in common
  bool in_pairs;             ///< two may be of one face, and lie in a plane
  /// A smooth boundary rises by size times turn over this above a facet that turns by theta towards
  /// the next one: an arc c theta / 8 above its chord; a ball (c / sqrt 3)^2 / 2R above an
  /// equilateral triangle, where faces turn by 2 c / (sqrt(12) R): c theta / sqrt(12).
  double flatness;
  Vec3 (*area_vector)(const Corners& x);
  double (*size)(const Corners& x);
  double (*angle_at)(const Corners& x, std::size_t corner); ///< the part of a normal there
  NearestTrianglePoint (*nearest)(const Vec3& x, const Corners& of);

  static const base::ByDimension<FacetKind> kinds;
};

const base::ByDimension<BodyBoundary::FacetKind> BodyBoundary::FacetKind::kinds{
    {.corners = 2,
     .ridge_corners = 1,
     .in_pairs = false,
     .flatness = 8.0,
     .area_vector = [](const Corners& x) -> Vec3 { return (x[1] - x[0]).cross(Vec3::UnitZ()); },
     .size = [](const Corners& x) { return (x[1] - x[0]).norm(); },
     .angle_at = [](const Corners& /*x*/, std::size_t /*corner*/) { return 1.0; },
     .nearest = [](const Vec3& x,
                   const Corners& of) { return nearest_on_segment(x, of[0], of[1]); }},
    {.corners = 3,
     .ridge_corners = 2,
     .in_pairs = true,
     .flatness = std::sqrt(12.0),
     .area_vector = [](const Corners& x) -> Vec3 { return (x[1] - x[0]).cross(x[2] - x[0]); },
     .size =
         [](const Corners& x) {
           return std::max({(x[1] - x[0]).norm(), (x[2] - x[1]).norm(), (x[0] - x[2]).norm()});
         },
     .angle_at =
         [](const Corners& x, std::size_t i) {
           return angle_between(x[(i + 1) % 3] - x[i], x[(i + 2) % 3] - x[i]);
         },
     .nearest = [](const Vec3& x, const Corners& of) { return nearest_point(x, of); }}};

BodyBoundary::BodyBoundary(int dim, const std::vector<FlatBoundaryFacet>& facets)
    : kind_(&FacetKind::kinds.at(dim)) {
  std::vector<Box<3>> boxes;
  for (const FlatBoundaryFacet& facet : facets) {
    const std::array<Vec3, 3>& x = facet.x;
    facets_.push_back({x, kind_->area_vector(x).normalized()});
    boxes.push_back(Box<3>::around(std::span(x).first(kind_->corners)));
    box_.extend(boxes.back());
  }
  tree_ = BoxTree<3>(boxes);
  sum_at_corners(facets);
  join(ridges(facets));
}

void BodyBoundary::sum_at_corners(const std::vector<FlatBoundaryFacet>& facets) {
  const std::size_t corners = kind_->corners;
  std::map<std::size_t, Vec3> sums;
  for (std::size_t f = 0; f < facets.size(); ++f) {
    const std::array<Vec3, 3>& x = facets[f].x;
    for (std::size_t i = 0; i < corners; ++i) {
      sums.try_emplace(facets[f].vertex[i], Vec3::Zero()).first->second +=
          kind_->angle_at(x, i) * facets_[f].normal;
    }
  }
  for (std::size_t f = 0; f < facets.size(); ++f) {
    for (std::size_t i = 0; i < corners; ++i) {
      facets_[f].at_corner[i] = sums.at(facets[f].vertex[i]);
    }
    facets_[f].at_edge.fill(facets_[f].normal);
  }
}

std::vector<BodyBoundary::Ridge>
BodyBoundary::ridges(const std::vector<FlatBoundaryFacet>& facets) const {
  // By their vertices, so that those of two facets follow each other.
  std::vector<std::tuple<std::size_t, std::size_t, std::size_t, std::size_t>> all;
  for (std::size_t f = 0; f < facets.size(); ++f) {
    for (std::size_t i = 0; i < kind_->corners; ++i) {
      const std::size_t first = facets[f].vertex[i];
      const std::size_t next = facets[f].vertex[(i + kind_->ridge_corners - 1) % 3];
      all.emplace_back(std::min(first, next), std::max(first, next), f, i);
    }
  }
  std::ranges::sort(all);
  std::vector<Ridge> shared;
  for (std::size_t k = 0; k + 1 < all.size(); ++k) {
    const auto& [a, b, f, i] = all[k];
    const auto& [c, d, g, j] = all[k + 1];
    if (a == c && b == d) {
      shared.push_back({std::pair(f, i), std::pair(g, j)});
    }
  }
  return shared;
}

void BodyBoundary::join(const std::vector<Ridge>& ridges) {
  std::vector<Ridge> smooth;
  for (const Ridge& ridge : ridges) {
    const auto& [f, i] = ridge[0];
    const auto& [g, j] = ridge[1];
    facets_[f].at_edge[i] = facets_[g].at_edge[j] = facets_[f].normal + facets_[g].normal;
    const double turn = angle_between(facets_[f].normal, facets_[g].normal);
    if (!(turn < sharp_turn)) {
      continue;
    }
    smooth.push_back(ridge);
    for (const std::size_t p : {f, g}) {
      const double rise = kind_->size(facets_[p].x) * turn / kind_->flatness;
      facets_[p].rise = std::max(facets_[p].rise, rise);
    }
  }
  if (!kind_->in_pairs) {
    return;
  }
  // The curve above two in a plane is that beside them.
  std::vector<double> rise;
  std::ranges::transform(facets_, std::back_inserter(rise), &FacetWithNormals::rise);
  for (const Ridge& ridge : smooth) {
    const std::size_t f = ridge[0].first;
    const std::size_t g = ridge[1].first;
    facets_[f].rise = std::max(facets_[f].rise, rise[g]);
    facets_[g].rise = std::max(facets_[g].rise, rise[f]);
  }
}

std::optional<BoundaryDistance> BodyBoundary::signed_distance(const Vec3& x, double reach) const {
  std::optional<BoundaryDistance> found;
  double best = reach;
  std::size_t nearest = 0;
  const auto look_at = [&](std::size_t f) {
    const FacetWithNormals& facet = facets_[f];
    const NearestTrianglePoint at = kind_->nearest(x, facet.x);
    const Vec3 off = x - at.x;
    const double distance = off.norm();
    // Of several as near the last.
    if (distance < best || (distance == best && f >= nearest)) {
      best = distance;
      nearest = f;
      const Vec3& n = at.corner >= 0 ? facet.at_corner[static_cast<std::size_t>(at.corner)]
                      : at.edge >= 0 ? facet.at_edge[static_cast<std::size_t>(at.edge)]
                                     : facet.normal;
      found = BoundaryDistance{off.dot(n) < 0.0 ? -best : best, facet.rise};
    }
    return best;
  };
  tree_.visit_nearest(x, look_at, reach);
  return found;
}

} // namespace spricka::geometry
