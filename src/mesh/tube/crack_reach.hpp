// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "mesh/tube/plane_polygons.hpp"
#include "mesh/tube/tube.hpp"

#include <vector>

namespace spricka::mesh {

/// Where a crack and its tubes are, for distances, in the frame of a patch.
class CrackDistanceField {
public:
  /// How sizes grow with the distance from a tube, for each unit of length.
  static constexpr double usual_growth = 0.3;

  explicit CrackDistanceField(PlanePolygons area) : area_(std::move(area)) {}
  void add_tube(const Tube& tube);

  struct CrackDistances {
    double front = 0.0;   ///< from the nearest front
    double radius = 0.0;  ///< of the tube there
    double size = 0.0;    ///< of elements up to that radius
    double surface = 0.0; ///< from the crack's faces
  };
  [[nodiscard]] CrackDistances distance(const base::Vec3& p) const;
  [[nodiscard]] const PlaneBasis& plane() const { return area_.plane(); }
  [[nodiscard]] const PlanePolygons& polygons() const { return area_; }
  /// Whether it has a front without a tube.
  [[nodiscard]] bool has_tubeless_front() const { return free_; }
  /// A ball that holds the crack and its tubes.
  [[nodiscard]] const base::Vec3& centre() const { return middle_; }
  [[nodiscard]] double radius() const { return radius_; }

private:
  struct FrontSegment {
    base::Vec3 from, to;
    double radius = 0.0;
    double size = 0.0;
  };
  PlanePolygons area_;
  std::vector<FrontSegment> pieces_;
  base::Vec3 middle_ = base::Vec3::Zero();
  double radius_ = 0.0;
  bool free_ = false;
};

/// Size of the elements wanted at a distance from a front.
inline double size_at_front_distance(const CrackDistanceField::CrackDistances& d,
                                     double growth = CrackDistanceField::usual_growth) {
  return d.size + growth * std::max(0.0, d.front - d.radius);
}

} // namespace spricka::mesh
