// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/slide.hpp"

#include "contact/rigid_target.hpp"
#include "contact/segment.hpp"
#include "contact/space_slide.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace spricka::contact {

namespace {

constexpr std::array<double, 2> gauss{-0.5773502691896258, 0.5773502691896258};

// The edge where displacements have taken it.
Edge moved(Edge edge, const base::Vector& u) {
  for (std::size_t i = 0; i < static_cast<std::size_t>(edge.count); ++i) {
    edge.x[i] += u.segment<2>(2 * static_cast<Eigen::Index>(edge.nodes[i].index()));
  }
  return edge;
}

// The displacement of a point of an edge.
Vec2 shift_at(const Edge& edge, double xi, const base::Vector& u) {
  const std::array<double, 3> N = edge_N(edge, xi);
  Vec2 sum = Vec2::Zero();
  for (std::size_t i = 0; i < static_cast<std::size_t>(edge.count); ++i) {
    sum += N[i] * u.segment<2>(2 * static_cast<Eigen::Index>(edge.nodes[i].index()));
  }
  return sum;
}

class Sliding {
public:
  Sliding(const PairConstraints& pair, const base::Vector& lambda, const base::Vector& u,
          std::span<const base::Matrix* const> motions)
      : pair_(pair), lambda_(lambda), u_(u), motions_(motions), edges_(pair.contact.plane.edges),
        targets_(pair.target.plane.edges), row_(normal_rows(pair)) {
    for (std::size_t i = 0; i < pair.normal.size(); ++i) {
      largest_ = std::max(largest_, lambda[static_cast<Eigen::Index>(i)]);
    }
    for (const Edge& target : targets_) {
      moved_.push_back(moved(target, u));
    }
  }

  SlideMeasures look() {
    if (!(largest_ > 0.0)) {
      return {};
    }
    for (const MortarSegment& s : pair_.rigid ? find_segments(pair_.contact, *pair_.rigid)
                                              : find_segments(pair_.contact, pair_.target)) {
      for (const double r : gauss) {
        add(s, 0.5 * ((s.to + s.from) + (s.to - s.from) * r));
      }
    }
    found_.thrust = thrust_;
    found_.unsupported_part = thrust_ > 0.0 ? unsupported_ / thrust_ : 0.0;
    return found_;
  }

private:
  // Sum of multipliers times hats, the traction that the rows stand for. Nodes whose row was merged
  // into a neighbour's have none of their own.
  [[nodiscard]] double pressure(const Edge& edge, double xi) const {
    const std::array<double, 3> phi = edge_hats(edge, xi);
    double p = 0.0;
    for (std::size_t i = 0; i < static_cast<std::size_t>(edge.count); ++i) {
      const auto row = row_.find(edge.nodes[i]);
      p += row == row_.end() ? 0.0 : phi[i] * lambda_[static_cast<Eigen::Index>(row->second)];
    }
    return p;
  }

  // The gap of the deformed bodies from a point on along a normal; none: nothing is there.
  [[nodiscard]] std::optional<double> gap_from(const Vec2& x, const Vec2& n, double near) const {
    std::optional<double> gap;
    for (const Edge& target : moved_) {
      const Vec2 centre = point_on(target, 0.0);
      const double radius = std::max((target.x[0] - centre).norm(), (target.x[1] - centre).norm());
      // Farther off than the drawn gap and the motion since: not what the point faces.
      if ((centre - x).norm() > 1.01 * radius + near) {
        continue;
      }
      const std::optional<double> eta = ray_intersection(target, x, n);
      if (eta && std::abs(*eta) <= 1.0 + 1e-6) {
        const double g = (point_on(target, *eta) - x).dot(n);
        // The nearest of several: the ray may run on through the body and out at its far side.
        gap = !gap || std::abs(g) < std::abs(*gap) ? g : *gap;
      }
    }
    return gap;
  }

  void add(const MortarSegment& s, double xi) {
    const Edge& edge = edges_[s.contact_edge];
    const double p = pressure(edge, xi);
    if (p <= least_looked_at * largest_) {
      return;
    }
    const Vec2 x = point_on(edge, xi);
    const double length = 0.5 * (s.to - s.from) * tangent_on(edge, xi).norm();
    const double thrust = p * length * out_of_plane_depth(pair_.contact, pair_.target, x);
    Vec2 n = surface_normal(pair_.contact, edge, xi);
    // Motion of the target side less that of this one, as rows weigh it.
    Vec2 relative = -shift_at(edge, xi, u_);
    double drawn = 0.0;
    double facet = edge.length;
    std::optional<double> now;
    Vec2 place;
    std::optional<double> eta;
    if (pair_.rigid) {
      const std::optional<RigidProjection> before = normal_projection(*pair_.rigid, x);
      const std::optional<RigidProjection> after = normal_projection(*pair_.rigid, x - relative);
      if (!before || !after) {
        return;
      }
      n = before->normal;
      drawn = before->gap;
      // Beyond the end of a line there is nothing to press on.
      now = after->beyond ? std::nullopt : std::optional(after->gap);
      place = point_on(moved(edge, u_), xi);
    } else {
      const Edge& target = targets_[s.target_edge];
      eta = ray_intersection(target, x, n);
      if (!eta) {
        return;
      }
      drawn = (point_on(target, *eta) - x).dot(n);
      facet = std::max(facet, target.length);
      const Edge here = moved(edge, u_);
      const Vec2 at = point_on(here, xi);
      relative += shift_at(target, *eta, u_);
      // Along the normal as it is now: bodies that have turned face one another otherwise.
      now = gap_from(at, outer_normal(here, xi), std::abs(drawn) + relative.norm());
      place = point_on(moved_[s.target_edge], *eta);
    }
    const double counted = drawn + n.dot(relative);
    // A row takes the gap to be the drawn one and the motion along the drawn normal; what is more
    // is of second order, and no row counts it.
    found_.places.push_back(
        {.x = base::to_space(place),
         .thrust = thrust,
         .gap = counted,
         .unseen = now ? std::optional(*now - counted) : std::nullopt,
         .normal = base::to_space(n),
         .relative_motions = relative_motions(motions_, [&](const base::Vector& motion) {
           const Vec2 own = shift_at(edge, xi, motion);
           return eta ? Vec2(shift_at(targets_[s.target_edge], *eta, motion) - own) : Vec2(-own);
         })});
    thrust_ += thrust;
    found_.pressed += length;
    // The part of the motion along the surface.
    const double way = std::abs(n.x() * relative.y() - n.y() * relative.x());
    if (way > found_.way) {
      found_.way = way;
      found_.facet = facet;
    }
    if (!now) {
      unsupported_ += thrust;
    } else {
      found_.misfit = std::max(found_.misfit, std::abs(*now - counted));
    }
  }

  const PairConstraints& pair_;
  const base::Vector& lambda_;
  const base::Vector& u_;
  std::span<const base::Matrix* const> motions_;
  std::span<const Edge> edges_, targets_;
  std::vector<Edge> moved_;
  std::map<base::NodeId, std::size_t> row_;
  double largest_ = 0.0, thrust_ = 0.0, unsupported_ = 0.0;
  SlideMeasures found_;
};

} // namespace

SlideMeasures measure_slide(const PairConstraints& pair, const base::Vector& lambda,
                            const base::Vector& u, std::span<const base::Matrix* const> motions) {
  return pair.contact.space.faces.empty() ? Sliding(pair, lambda, u, motions).look()
                                          : measure_space_slide(pair, lambda, u, motions);
}

} // namespace spricka::contact
