// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "mesh/tube/solid_crack.hpp"
#include "mesh/tube/solid_front.hpp"
#include "mesh/tube/tube.hpp"

#include <span>
#include <utility>
#include <vector>

/// How much room there is for tubes: distances from cracks and their tubes, and what is round a
/// front.
namespace spricka::mesh {

/// Where a crack and its tubes are, for distances, in the frame of a patch.
class CrackDistanceField {
public:
  explicit CrackDistanceField(PlanePolygons area) : area_(std::move(area)) {}
  void add_tube(const Tube& tube);

  struct DistancesFromCrack {
    double front = 0.0;   ///< from the nearest front
    double radius = 0.0;  ///< of the tube there
    double size = 0.0;    ///< of elements up to that radius
    double surface = 0.0; ///< from the crack's faces
  };
  [[nodiscard]] DistancesFromCrack distance(const base::Vec3& p) const;
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

/// Sizes of the elements round the tubes of a crack.
struct FillSizes {
  double finer = 1.0;                               ///< TubeMeshParameters::finer
  double growth = TubeMeshParameters::usual_growth; ///< TubeMeshParameters::growth

  /// With the distance, for each unit of length.
  [[nodiscard]] double growth_with_distance() const { return growth / finer; }
  /// Of the elements wanted at a distance from a front.
  [[nodiscard]] double size_at(const CrackDistanceField::DistancesFromCrack& d) const {
    return (d.size + growth_with_distance() * std::max(0.0, d.front - d.radius)) / finer;
  }
};

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
