// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "mesh/tube/plane_polygons.hpp"
#include "mesh/tube/solid_front.hpp"
#include "mesh/tube/tube.hpp"

#include <span>
#include <vector>

namespace spricka::mesh {

/// What is round a front of a crack: surfaces, other materials, other cracks, and how far the crack
/// reaches behind it. Lengths are those of the deck.
class TubeClearance {
public:
  TubeClearance(const SolidHostMesh& host, const LocatedSolidCrack& request,
                const InteriorFront& front, std::span<const LocatedSolidCrack> all);

  [[nodiscard]] double clearance(double s) const;
  /// Twice the distance to a mouth, where the crack ends there: a surface crack is as half of one
  /// inside.
  [[nodiscard]] double crack_width(double s) const;
  /// Distance to where the crack is bent.
  [[nodiscard]] double kink_distance(double s) const;
  /// Tangent of the angle between the front and the surface's normal at an end of an open front.
  [[nodiscard]] double end_inclination(std::size_t end) const;

private:
  [[nodiscard]] double free_at(const FrontFrame& at) const;
  [[nodiscard]] double across_section(const FrontFrame& at) const;

  const SolidHostMesh& host_;
  const LocatedSolidCrack& request_;
  const InteriorFront& front_;
  PlanePolygons area_;
  std::vector<PlanePolygons> others_;
  std::vector<double> free_; ///< at equal steps
};

} // namespace spricka::mesh
