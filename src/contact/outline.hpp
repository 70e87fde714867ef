// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "contact/surface.hpp"

#include <map>
#include <optional>
#include <utility>
#include <vector>

/// The boundary of a body in the plane as a polyline, to ask whether points lie inside.
namespace spricka::contact {

/// The nearest place of an outline.
struct BoundaryDistance {
  double distance = 0.0; ///< negative inside the body [length]
  double facet = 0.0;    ///< how far the polyline may leave the curve there [length]
};

class BoundaryPolyline {
public:
  /// The outline of a surface moved by u [2 * node] [length]; empty: as drawn. Quadratic edges
  /// become four straight ones.
  BoundaryPolyline(const ContactSurface& surface, const base::Vector& u);

  /// The nearest place no further off than `reach`, if there is one.
  [[nodiscard]] std::optional<BoundaryDistance> signed_distance(const Vec2& x, double reach) const;
  [[nodiscard]] const Vec2& lower_corner() const { return low_; } ///< corners of the bounding box
  [[nodiscard]] const Vec2& upper_corner() const { return high_; }

private:
  struct PolylineSegment {
    Vec2 a, b;
    Vec2 at_a, at_b;   ///< sums of the normals that meet at its ends
    double turn = 0.0; ///< to its neighbours, corners left out [rad]
  };
  using QuadratureCell = std::pair<long, long>;
  [[nodiscard]] QuadratureCell cell_of(const Vec2& x) const;
  void look(const Vec2& x, std::size_t i, double& best,
            std::optional<BoundaryDistance>& found) const;
  void add_chain(std::vector<Vec2> points, bool closed);
  void sort_in();

  std::vector<PolylineSegment> pieces_;
  Vec2 low_ = Vec2::Zero(), high_ = Vec2::Zero();
  double size_ = 1.0; ///< of a cell
  std::map<QuadratureCell, std::vector<std::size_t>> cells_;
};

} // namespace spricka::contact
