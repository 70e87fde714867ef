// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "mesh/tube/plane_polygons.hpp"
#include "mesh/tube/tube.hpp"

#include <vector>

namespace spricka::mesh {

/// Where a crack and its tubes are, for distances, in the frame of a patch.
class CrackReach {
public:
  /// How sizes grow with the distance from a tube, for each unit of length.
  static constexpr double usual_growth = 0.3;

  explicit CrackReach(PlanePolygons area) : area_(std::move(area)) {}
  void add(const Tube& tube);

  struct Distance {
    double front = 0.0;   ///< from the nearest front
    double radius = 0.0;  ///< of the tube there
    double size = 0.0;    ///< of elements up to that radius
    double surface = 0.0; ///< from the crack's faces
  };
  [[nodiscard]] Distance distance(const base::Vec3& p) const;
  [[nodiscard]] const PlaneBasis& plane() const { return area_.plane(); }
  [[nodiscard]] const PlanePolygons& area() const { return area_; }
  /// Whether it has a front without a tube.
  [[nodiscard]] bool free() const { return free_; }
  /// A ball that holds the crack and its tubes.
  [[nodiscard]] const base::Vec3& middle() const { return middle_; }
  [[nodiscard]] double radius() const { return radius_; }

private:
  struct Piece {
    base::Vec3 from, to;
    double radius = 0.0;
    double size = 0.0;
  };
  PlanePolygons area_;
  std::vector<Piece> pieces_;
  base::Vec3 middle_ = base::Vec3::Zero();
  double radius_ = 0.0;
  bool free_ = false;
};

/// Size of the elements wanted at a distance from a front.
inline double size_at(const CrackReach::Distance& d, double growth = CrackReach::usual_growth) {
  return d.size + growth * std::max(0.0, d.front - d.radius);
}

} // namespace spricka::mesh
