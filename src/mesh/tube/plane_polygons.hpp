// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "geometry/triangle.hpp"
#include "mesh/tube/solid_crack.hpp"

#include <optional>
#include <vector>

namespace spricka::mesh {

/// Areas of a plane, within closed polygons; those within others are holes.
class PlanePolygons {
public:
  PlanePolygons(const PlaneBasis& plane, const std::vector<std::vector<base::Vec3>>& outlines);
  /// In the plane of a crack.
  PlanePolygons(const SolidCrack& crack, const std::vector<std::vector<base::Vec3>>& outlines);

  [[nodiscard]] const PlaneBasis& plane() const { return plane_; }
  [[nodiscard]] const std::vector<std::vector<base::Vec2>>& outlines() const { return outlines_; }
  [[nodiscard]] bool contains(const base::Vec2& q) const;
  [[nodiscard]] double area() const; ///< without holes
  /// Of a place in space from the areas; of a place in the plane from their outlines.
  [[nodiscard]] double distance(const base::Vec3& x) const;
  [[nodiscard]] double distance_to_outlines(const base::Vec2& q) const;
  /// Whether a place of the plane lies within the areas, farther than `rim` from their outlines.
  [[nodiscard]] bool is_well_within(const base::Vec2& q, double rim) const {
    return contains(q) && distance_to_outlines(q) > rim;
  }
  /// Places along the line in which a triangle cuts the plane; empty: it does not.
  [[nodiscard]] std::vector<base::Vec3>
  intersect_triangle(const geometry::CornerPlaces& triangle) const;
  /// Where the line from q along d leaves the areas, as a multiple of d; of the first that is not
  /// at q. Empty: it does not.
  [[nodiscard]] std::optional<double> exit_distance(const base::Vec2& q, const base::Vec2& d) const;

private:
  PlaneBasis plane_;
  std::vector<std::vector<base::Vec2>> outlines_;
};

} // namespace spricka::mesh
