// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/space_slide.hpp"

#include "base/index.hpp"
#include "contact/space/rigid_round.hpp"
#include "contact/space_rows.hpp"
#include "shape/quadrature.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace spricka::contact {

using base::index;

namespace {

constexpr int rule_degree = 5;

Vec3 motion_of(base::NodeId node, const base::Vector& u) {
  return u.segment<3>(3 * index(node.index()));
}

// The surface where displacements have taken it; its normals are those of its faces.
SpaceSurface moved(SpaceSurface surface, const base::Vector& u) {
  for (geometry::ElementSide& face : surface.faces) {
    for (std::size_t i = 0; i < face.nodes.size(); ++i) {
      face.X.col(index(i)) += motion_of(face.nodes[i], u);
    }
  }
  surface.rounds.assign(surface.rounds.size(), std::nullopt);
  return surface;
}

// The displacement of a point of a face.
Vec3 shift_at(const geometry::ElementSide& face, const Vec2& r, const base::Vector& u) {
  const geometry::SideValues N = face.N(r);
  Vec3 sum = Vec3::Zero();
  for (std::size_t i = 0; i < face.nodes.size(); ++i) {
    sum += N[index(i)] * motion_of(face.nodes[i], u);
  }
  return sum;
}

double largest_shift(const base::Vector& u) {
  double most = 0.0;
  for (Eigen::Index i = 0; i + 2 < u.size(); i += 3) {
    most = std::max(most, u.segment<3>(i).norm());
  }
  return most;
}

class SpaceSliding {
public:
  SpaceSliding(const PairConstraints& pair, const base::Vector& lambda, const base::Vector& u,
               std::span<const base::Matrix* const> motions)
      : pair_(pair), lambda_(lambda), u_(u), motions_(motions), own_(pair.contact.space),
        other_(pair.target.space), moved_own_(moved(own_, u)), moved_other_(moved(other_, u)),
        // Fits move bodies as far as they are large: what a body is moved off by is still opposite.
        projection_(moved_own_, moved_other_, 2.0 * largest_shift(u)),
        functions_(functions_by_face(pair)) {
    for (std::size_t i = 0; i < pair.normal.size(); ++i) {
      largest_ = std::max(largest_, lambda[index(i)]);
    }
    for (const geometry::ElementSide& face : own_.faces) {
      own_size_.push_back(std::sqrt(face.area()));
    }
    for (const geometry::ElementSide& face : other_.faces) {
      other_size_.push_back(std::sqrt(face.area()));
    }
  }

  SlideMeasures look() {
    if (!(largest_ > 0.0)) {
      return {};
    }
    const auto see = points_of();
    for (const SurfaceTriangle& triangle : own_.triangles) {
      const Eigen::Vector3d p = pressures(triangle);
      if (p.maxCoeff() <= least_looked_at * largest_) {
        continue;
      }
      for (const ProjectionPoint& point : see(triangle)) {
        add(triangle, point, p.dot(point.hat));
      }
    }
    found_.thrust = thrust_;
    found_.unsupported_part = thrust_ > 0.0 ? unsupported_ / thrust_ : 0.0;
    found_.pressed = std::sqrt(found_.pressed);
    return found_;
  }

private:
  // Points of a triangle that see the target as drawn. Of a body those of one rule on the whole
  // triangle: rows clip it by all that is opposite, but what is told here are largest ways.
  [[nodiscard]] std::function<std::vector<ProjectionPoint>(const SurfaceTriangle&)>
  points_of() const {
    if (pair_.rigid_shape) {
      return [see = target_projector(pair_)](const SurfaceTriangle& t) { return see(t).points; };
    }
    return [this, drawn = std::make_shared<const SurfaceProjection>(own_, other_)](
               const SurfaceTriangle& t) { return looked_at(t, *drawn); };
  }

  [[nodiscard]] std::vector<ProjectionPoint> looked_at(const SurfaceTriangle& t,
                                                       const SurfaceProjection& drawn) const {
    const geometry::ElementSide& face = own_.faces[t.face];
    const std::array<Vec2, 3> r = corner_coordinates(face, t.node);
    const Vec2 a = r[1] - r[0];
    const Vec2 b = r[2] - r[0];
    const double r_area2 = std::abs(a.x() * b.y() - a.y() * b.x());
    std::vector<ProjectionPoint> points;
    for (const auto& [q, weight] : shape::triangle_rule(rule_degree)) {
      const Vec2 at = r[0] + q[0] * a + q[1] * b;
      const geometry::SidePoint here = face.point(at);
      if (std::optional<ProjectionPoint> met =
              drawn.project_along_normal(here.x, surface_normal(own_, t.face, here))) {
        met->hat = {1.0 - q[0] - q[1], q[0], q[1]};
        met->r = at;
        met->weight = weight * r_area2 * here.area_vector().norm();
        points.push_back(*met);
      }
    }
    return points;
  }

  // At the corners of a triangle; functions that joined another have its pressure.
  [[nodiscard]] Eigen::Vector3d pressures(const SurfaceTriangle& triangle) const {
    Eigen::Vector3d p = Eigen::Vector3d::Zero();
    for (std::size_t i = 0; i < triangle.node.size(); ++i) {
      const std::size_t at = functions_[triangle.face][static_cast<std::size_t>(triangle.node[i])];
      const int row = pair_.functions[at].row;
      p[index(i)] = row >= 0 ? lambda_[row] : 0.0;
    }
    return p;
  }

  void add(const SurfaceTriangle& triangle, const ProjectionPoint& at, double p) {
    if (p <= least_looked_at * largest_) {
      return;
    }
    // Motion of the target side less that of this one, as rows weigh it.
    Vec3 relative = -shift_at(own_.faces[triangle.face], at.r, u_);
    double facet = own_size_[triangle.face];
    std::optional<double> now;
    const geometry::SidePoint here = moved_own_.faces[triangle.face].point(at.r);
    Vec3 place = here.x;
    if (pair_.rigid_shape) {
      const AnalyticShape& shape = *pair_.rigid_shape;
      now = shape.sense * distance_to(shape, at.x - relative);
    } else {
      relative += shift_at(other_.faces[at.target], at.s, u_);
      facet = std::max(facet, other_size_[at.target]);
      // Along the normal as it is now: bodies that have turned face one another otherwise.
      if (const auto met =
              projection_.project_along_normal(here.x, here.area_vector().normalized())) {
        now = met->gap;
      }
      place = moved_other_.faces[at.target].position(at.s);
    }
    const double counted = at.gap + at.normal.dot(relative);
    // A row takes the gap to be the drawn one and the motion along the drawn normal; what is more
    // is of second order, and no row counts it.
    found_.places.push_back(
        {.x = place,
         .thrust = p * at.weight,
         .gap = counted,
         .unseen = now ? std::optional(*now - counted) : std::nullopt,
         .normal = at.normal,
         .relative_motions = relative_motions(motions_, [&](const base::Vector& motion) {
           const Vec3 own = shift_at(own_.faces[triangle.face], at.r, motion);
           return pair_.rigid_shape ? Vec3(-own)
                                    : Vec3(shift_at(other_.faces[at.target], at.s, motion) - own);
         })});
    thrust_ += p * at.weight;
    found_.pressed += at.weight;
    // The part of the motion along the surface.
    const double way = (relative - at.normal.dot(relative) * at.normal).norm();
    if (way > found_.way) {
      found_.way = way;
      found_.facet = facet;
    }
    if (!now) {
      unsupported_ += p * at.weight;
    } else {
      found_.misfit = std::max(found_.misfit, std::abs(*now - counted));
    }
  }

  const PairConstraints& pair_;
  const base::Vector& lambda_;
  const base::Vector& u_;
  std::span<const base::Matrix* const> motions_;
  const SpaceSurface& own_;
  const SpaceSurface& other_;
  SpaceSurface moved_own_, moved_other_;
  SurfaceProjection projection_; ///< of the moved target
  std::vector<std::vector<std::size_t>> functions_;
  std::vector<double> own_size_, other_size_; ///< [face]
  double largest_ = 0.0, thrust_ = 0.0, unsupported_ = 0.0;
  SlideMeasures found_;
};

} // namespace

SlideMeasures measure_space_slide(const PairConstraints& pair, const base::Vector& lambda,
                                  const base::Vector& u,
                                  std::span<const base::Matrix* const> motions) {
  return SpaceSliding(pair, lambda, u, motions).look();
}

} // namespace spricka::contact
