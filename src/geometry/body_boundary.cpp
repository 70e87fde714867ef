// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/body_boundary.hpp"

#include "base/by_dimension.hpp"
#include "geometry/polyline.hpp"
#include "geometry/triangle.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

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
    : kind_(&FacetKind::kinds.at(dim)), facets_(facets) {
  std::vector<Box<3>> boxes;
  boxes.reserve(facets.size());
  for (const FlatBoundaryFacet& facet : facets) {
    boxes.push_back(Box<3>::around(std::span(facet.x).first(kind_->corners)));
    box_.extend(boxes.back());
  }
  tree_ = BoxTree<3>(boxes);
  collect_facets_at_vertices();
}

void BodyBoundary::collect_facets_at_vertices() {
  std::size_t highest = 0;
  lowest_ = facets_.empty() ? 0 : facets_.front().vertex[0];
  const auto visit_corners = [&](const auto& visit) {
    for (std::size_t f = 0; f < facets_.size(); ++f) {
      for (std::size_t i = 0; i < kind_->corners; ++i) {
        visit(facets_[f].vertex[i], FacetCorner{f, i});
      }
    }
  };
  visit_corners([&](std::size_t vertex, const FacetCorner&) {
    lowest_ = std::min(lowest_, vertex);
    highest = std::max(highest, vertex);
  });
  first_.assign(highest - lowest_ + 2, 0);
  visit_corners([&](std::size_t vertex, const FacetCorner&) { ++first_[vertex - lowest_ + 1]; });
  std::partial_sum(first_.begin(), first_.end(), first_.begin());
  at_vertex_.resize(first_.back());
  std::vector<std::size_t> next(first_.begin(), first_.end() - 1);
  visit_corners([&](std::size_t vertex, const FacetCorner& corner) {
    at_vertex_[next[vertex - lowest_]++] = corner;
  });
}

Vec3 BodyBoundary::facet_normal(std::size_t f) const {
  return kind_->area_vector(facets_[f].x).normalized();
}

Vec3 BodyBoundary::corner_normal(std::size_t f, std::size_t corner) const {
  Vec3 sum = Vec3::Zero();
  for (const FacetCorner& at : facets_at(facets_[f].vertex[corner])) {
    sum += kind_->angle_at(facets_[at.facet].x, at.corner) * facet_normal(at.facet);
  }
  return sum;
}

std::span<const BodyBoundary::FacetCorner> BodyBoundary::facets_at(std::size_t vertex) const {
  const std::size_t from = first_[vertex - lowest_];
  return std::span(at_vertex_).subspan(from, first_[vertex - lowest_ + 1] - from);
}

std::vector<BodyBoundary::FacetCorner> BodyBoundary::facets_at_ridge(std::size_t f,
                                                                     std::size_t ridge) const {
  // In the plane both ends are one.
  const auto other_end = [&](const FacetCorner& at) {
    return facets_[at.facet].vertex[(at.corner + kind_->ridge_corners - 1) % 3];
  };
  const std::size_t a = facets_[f].vertex[ridge];
  const std::size_t b = other_end({f, ridge});
  std::vector<FacetCorner> found;
  for (const FacetCorner& at : facets_at(a)) {
    if (other_end(at) == b) {
      found.push_back(at);
    }
  }
  if (a != b) {
    for (const FacetCorner& at : facets_at(b)) {
      if (other_end(at) == a) {
        found.push_back(at);
      }
    }
  }
  std::ranges::sort(found, {},
                    [](const FacetCorner& at) { return std::pair(at.facet, at.corner); });
  return found;
}

Vec3 BodyBoundary::ridge_normal(std::size_t f, std::size_t ridge) const {
  const std::vector<FacetCorner> all = facets_at_ridge(f, ridge);
  if (all.size() < 2) {
    return facet_normal(f);
  }
  const auto own = std::ranges::find_if(
      all, [&](const FacetCorner& at) { return at.facet == f && at.corner == ridge; });
  // Of several that of the next one.
  const FacetCorner& other = own + 1 != all.end() ? *(own + 1) : *(own - 1);
  return facet_normal(f) + facet_normal(other.facet);
}

std::vector<std::pair<std::size_t, double>> BodyBoundary::smooth_neighbours(std::size_t f) const {
  std::vector<std::pair<std::size_t, double>> found;
  for (std::size_t i = 0; i < kind_->corners; ++i) {
    const std::vector<FacetCorner> all = facets_at_ridge(f, i);
    for (std::size_t k = 0; k + 1 < all.size(); ++k) {
      for (const auto& [own, other] :
           {std::pair(all[k], all[k + 1]), std::pair(all[k + 1], all[k])}) {
        if (own.facet != f || own.corner != i) {
          continue;
        }
        const double turn =
            angle_between(facet_normal(all[k].facet), facet_normal(all[k + 1].facet));
        if (turn < sharp_turn) {
          found.emplace_back(other.facet, turn);
        }
      }
    }
  }
  return found;
}

double BodyBoundary::rise_towards_neighbours(std::size_t f) const {
  double most = 0.0;
  for (const auto& [other, turn] : smooth_neighbours(f)) {
    most = std::max(most, kind_->size(facets_[f].x) * turn / kind_->flatness);
  }
  return most;
}

double BodyBoundary::rise(std::size_t f) const {
  double most = rise_towards_neighbours(f);
  if (kind_->in_pairs) { // the curve above two in a plane is that beside them
    for (const auto& [other, turn] : smooth_neighbours(f)) {
      most = std::max(most, rise_towards_neighbours(other));
    }
  }
  return most;
}

std::optional<BoundaryDistance> BodyBoundary::signed_distance(const Vec3& x, double reach) const {
  std::optional<NearestTrianglePoint> found;
  double best = reach;
  std::size_t nearest = 0;
  const auto look_at = [&](std::size_t f) {
    const NearestTrianglePoint at = kind_->nearest(x, facets_[f].x);
    const double distance = (x - at.x).norm();
    // Of several as near the last.
    if (distance < best || (distance == best && f >= nearest)) {
      best = distance;
      nearest = f;
      found = at;
    }
    return best;
  };
  tree_.visit_nearest(x, look_at, reach);
  if (!found) {
    return std::nullopt;
  }
  const Vec3 n = found->corner >= 0
                     ? corner_normal(nearest, static_cast<std::size_t>(found->corner))
                 : found->edge >= 0 ? ridge_normal(nearest, static_cast<std::size_t>(found->edge))
                                    : facet_normal(nearest);
  return BoundaryDistance{(x - found->x).dot(n) < 0.0 ? -best : best, rise(nearest)};
}

} // namespace spricka::geometry
