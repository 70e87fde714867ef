// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/slide.hpp"

#include "base/index.hpp"
#include "base/parallel.hpp"
#include "contact/make_rows.hpp"
#include "contact/pair_points.hpp"
#include "contact/space/opposite.hpp"
#include "contact/space/surface_projection.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

namespace spricka::contact {

using base::index;

namespace {

int dimension_of(const geometry::ElementSide& facet) {
  return facet.local_dim() + 1;
}

// The displacement of a point of a facet.
Vec3 displacement_at(const geometry::ElementSide& facet, const Vec2& r, const base::Vector& u) {
  const geometry::SideValues N = facet.N(r);
  const int dim = dimension_of(facet);
  Vec3 sum = Vec3::Zero();
  for (std::size_t i = 0; i < facet.nodes.size(); ++i) {
    sum.head(dim) += N[index(i)] * u.segment(dim * index(facet.nodes[i].index()), dim);
  }
  return sum;
}

// The surface where displacements have taken it; its normals are those of its facets.
ContactSurface displaced(ContactSurface surface, const base::Vector& u) {
  for (std::size_t f = 0; f < surface.facets.size(); ++f) {
    geometry::ElementSide& facet = surface.facets[f];
    const int dim = dimension_of(facet);
    for (std::size_t i = 0; i < facet.nodes.size(); ++i) {
      facet.X.col(index(i)).head(dim) += u.segment(dim * index(facet.nodes[i].index()), dim);
      if (facet.is_edge()) {
        surface.plane.edges[f].x[i] = facet.X.col(index(i)).head<2>();
      }
    }
  }
  surface.circle.reset();
  surface.rounds.assign(surface.rounds.size(), std::nullopt);
  return surface;
}

double largest_displacement(const base::Vector& u) {
  double most = 0.0;
  for (Eigen::Index i = 0; i + 2 < u.size(); i += 3) {
    most = std::max(most, u.segment<3>(i).norm());
  }
  return most;
}

// The length that an area of facets stands for in space, its root.
double size_of_measure(double measure, const geometry::ElementSide& facet) {
  return std::pow(measure, 1.0 / facet.local_dim());
}

double facet_size(const geometry::ElementSide& facet) {
  return size_of_measure(facet_length_or_area(facet), facet);
}

// The gap from a point on along a normal n to the edges of a surface, at most about `near` off;
// none: nothing is there.
std::optional<double> gap_to_edges(const std::vector<Edge>& edges, const Vec2& x, const Vec2& n,
                                   double near) {
  std::optional<double> gap;
  for (const Edge& edge : edges) {
    const Vec2 centre = point_on_edge(edge, 0.0);
    const double radius = std::max((edge.x[0] - centre).norm(), (edge.x[1] - centre).norm());
    // Farther off than the drawn gap and the motion since: not what the point faces.
    if ((centre - x).norm() > 1.01 * radius + near) {
      continue;
    }
    const std::optional<double> eta = ray_intersection(edge, x, n);
    if (eta && std::abs(*eta) <= 1.0 + 1e-6) {
      const double g = (point_on_edge(edge, *eta) - x).dot(n);
      // The nearest of several: the ray may run on through the body and out at its far side.
      gap = !gap || std::abs(g) < std::abs(*gap) ? g : *gap;
    }
  }
  return gap;
}

class SlideMeasurement {
public:
  SlideMeasurement(const PairConstraints& pair, const base::Vector& lambda, const base::Vector& u,
                   std::span<const base::Matrix* const> motions)
      : pair_(pair), lambda_(lambda), u_(u), motions_(motions), rows_(normal_rows_by_facet(pair)),
        moved_own_(displaced(pair.contact, u)), moved_other_(displaced(pair.target, u)) {
    if (!pair.rigid && pair.target.plane.edges.empty()) { // but faces
      // Fits move bodies as far as they are large: what a body is moved off by is still opposite.
      projection_.emplace(moved_own_, moved_other_, 2.0 * largest_displacement(u));
    }
  }

  SlideMeasures measure() {
    const double largest =
        pair_.normal.empty() ? 0.0 : lambda_.head(index(pair_.normal.size())).maxCoeff();
    if (!(largest > 0.0)) {
      return {};
    }
    const double least = least_looked_at * largest;
    const ElementProjector drawn = make_target_projector(pair_, ProjectionPointDensity::sampling);
    base::make_and_take_in_order(
        pair_.contact.elements.size(), elements_at_a_time,
        [&](std::size_t e) { return measure_element(pair_.contact.elements[e], drawn, least); },
        [&](std::size_t /*e*/, std::vector<PressedPoint>&& points) {
          for (PressedPoint& point : points) {
            add(point);
          }
        });
    found_.unsupported_part = found_.thrust > 0.0 ? unsupported_ / found_.thrust : 0.0;
    found_.pressed = size_of_measure(found_.pressed, pair_.contact.facets.front());
    return found_;
  }

private:
  struct PressedPoint {
    PairPoint drawn;
    double way = 0.0; ///< along the surface
    DisplacedContactPoint place;
  };

  [[nodiscard]] std::vector<PressedPoint>
  measure_element(const HatElement& element, const ElementProjector& project, double least) const {
    std::vector<PressedPoint> found;
    const Eigen::Vector3d p = pressures(element);
    if (p.maxCoeff() > least) {
      for (const PairPoint& at : project(element).points) {
        if (p.dot(at.hat) > least) {
          found.push_back(measure_point(at, p.dot(at.hat)));
        }
      }
    }
    return found;
  }

  // At the nodes of an element; functions that joined another have its pressure.
  [[nodiscard]] Eigen::Vector3d pressures(const HatElement& element) const {
    Eigen::Vector3d p = Eigen::Vector3d::Zero();
    for (std::size_t i = 0; i < element.node_count(); ++i) {
      const int row = rows_[element.facet][static_cast<std::size_t>(element.node[i])];
      p[index(i)] = row >= 0 ? lambda_[row] : 0.0;
    }
    return p;
  }

  // The gap of the deformed bodies at a point `here`, which has moved past the target by
  // `relative`; none: nothing stands opposite any more. Along the normal as it is now: bodies that
  // have turned face one another otherwise.
  [[nodiscard]] std::optional<double>
  gap_now(const PairPoint& drawn, const geometry::SidePoint& here, const Vec3& relative) const {
    if (pair_.rigid) {
      return gap_to_rigid_target(pair_, drawn.x - relative);
    }
    if (projection_) {
      const std::optional<PairPoint> met =
          projection_->project_along_normal(here.x, here.area_vector().normalized(), drawn);
      return met ? std::optional(met->gap) : std::nullopt;
    }
    return gap_to_edges(moved_other_.plane.edges, here.x.head<2>(), here.normal().head<2>(),
                        std::abs(drawn.gap) + relative.norm());
  }

  // Motion u of the target side less that of this one, as rows weigh it.
  [[nodiscard]] Vec3 relative_motion(const PairPoint& at, const base::Vector& u) const {
    Vec3 relative = -displacement_at(pair_.contact.facets[at.facet], at.r, u);
    if (!pair_.rigid) {
      relative += displacement_at(pair_.target.facets[at.target], at.s, u);
    }
    return relative;
  }

  // The same of each of the motions that were asked for. [3, motion]
  [[nodiscard]] base::Matrix relative_motions(const PairPoint& at) const {
    std::vector<Vec3> moved;
    for (const base::Matrix* motion : motions_) {
      for (const auto& one : motion->colwise()) {
        moved.push_back(relative_motion(at, one));
      }
    }
    base::Matrix found(3, index(moved.size()));
    for (std::size_t i = 0; i < moved.size(); ++i) {
      found.col(index(i)) = moved[i];
    }
    return found;
  }

  [[nodiscard]] PressedPoint measure_point(const PairPoint& at, double pressure) const {
    const Vec3 relative = relative_motion(at, u_);
    const geometry::SidePoint here = moved_own_.facets[at.facet].point(at.r);
    const std::optional<double> now = gap_now(at, here, relative);
    // A row takes the gap to be the drawn one and the motion along the drawn normal; what is more
    // is of second order, and no row counts it.
    const double counted = at.gap + at.normal.dot(relative);
    return {.drawn = at,
            .way = (relative - at.normal.dot(relative) * at.normal).norm(),
            .place = {.x = pair_.rigid ? here.x : moved_other_.facets[at.target].position(at.s),
                      .thrust = pressure * at.weight,
                      .gap = counted,
                      .unseen = now ? std::optional(*now - counted) : std::nullopt,
                      .normal = at.normal,
                      .relative_motions = relative_motions(at)}};
  }

  void add(PressedPoint& point) {
    const PairPoint& at = point.drawn;
    found_.thrust += point.place.thrust;
    found_.pressed += at.weight / out_of_plane_depth(pair_.contact, pair_.target, at.x.head<2>());
    if (point.way > found_.way) {
      found_.way = point.way;
      found_.facet = facet_size(pair_.contact.facets[at.facet]);
      if (!pair_.rigid) {
        found_.facet = std::max(found_.facet, facet_size(pair_.target.facets[at.target]));
      }
    }
    if (point.place.unseen) {
      found_.misfit = std::max(found_.misfit, std::abs(*point.place.unseen));
    } else {
      unsupported_ += point.place.thrust;
    }
    found_.places.push_back(std::move(point.place));
  }

  const PairConstraints& pair_;
  const base::Vector& lambda_;
  const base::Vector& u_;
  std::span<const base::Matrix* const> motions_;
  std::vector<std::vector<int>> rows_;
  ContactSurface moved_own_, moved_other_;
  std::optional<SurfaceProjector> projection_; ///< in space, of a moved target of facets
  double unsupported_ = 0.0;
  SlideMeasures found_;
};

} // namespace

SlideMeasures measure_slide(const PairConstraints& pair, const base::Vector& lambda,
                            const base::Vector& u, std::span<const base::Matrix* const> motions) {
  return SlideMeasurement(pair, lambda, u, motions).measure();
}

} // namespace spricka::contact
