// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "geometry/box_tree.hpp"
#include "report/drawing/svg.hpp"
#include "results/contact_result.hpp"

#include <array>
#include <memory>
#include <optional>
#include <vector>

namespace spricka::report {

/// A contact surface round an axis laid flat: x is the angle [rad], y the place along the axis.
class UnrolledSurface {
public:
  struct UnrolledCorner {
    DrawingPoint at;
    double p = 0.0; ///< as recovered
  };
  using Triangle = std::array<UnrolledCorner, 3>;

  /// `consistent`: the pressures are p_consistent, else p_lumped.
  UnrolledSurface(const results::ContactResult& contact, bool consistent);

  /// Those that reach across the seam at +-pi come twice, once on each side.
  [[nodiscard]] const std::vector<Triangle>& triangles() const { return triangles_; }
  [[nodiscard]] double lowest_axial_position() const { return low_; } ///< along the axis
  [[nodiscard]] double highest_axial_position() const { return high_; }
  [[nodiscard]] double largest_pressure() const { return largest_; }
  /// Linear between nodes; none where there is no surface.
  [[nodiscard]] std::optional<double> pressure_at(DrawingPoint at) const;
  /// What pressure pushes the surface by at a place along the axis, for a unit of length along it:
  /// towards angle 0 and pi/2.
  [[nodiscard]] DrawingPoint line_force_at_axial_position(double along) const;

private:
  std::vector<Triangle> triangles_;
  std::shared_ptr<const geometry::BoxTree<2>> tree_; ///< of the triangles
  double radius_ = 0.0;
  double low_ = 0.0, high_ = 0.0, largest_ = 0.0;
};

} // namespace spricka::report
