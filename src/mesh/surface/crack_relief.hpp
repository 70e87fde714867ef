// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "geometry/box.hpp"
#include "geometry/triangle.hpp"

#include <cstddef>
#include <functional>
#include <vector>

namespace spricka::mesh {

/// A crack that has turned out of its first plane, as heights over that plane: ruled strips between
/// the fronts it has had, the plane itself behind the first one, straight on before the last.
class NonPlanarCrackSurface {
public:
  /// The fronts it has had, the first of them in the plane, the last its present one. Closed ones
  /// end with their first point; all run the same way round, t = m x b.
  struct PastAndPresentFronts {
    base::Vec3 normal = base::Vec3::UnitZ();       ///< of the plane, unit
    std::vector<std::vector<base::Vec3>> points{}; ///< [front][point], two or more fronts
    std::vector<base::Vec3> normals{};             ///< [point of the last] of the crack there, unit
  };
  explicit NonPlanarCrackSurface(PastAndPresentFronts fronts);

  /// How far the crack lies above a place, along the normal of its plane.
  [[nodiscard]] double crack_height_over_plane(const base::Vec3& x) const;
  /// How that height of the crack changes in the plane, at right angles to its normal.
  [[nodiscard]] base::Vec3 crack_height_gradient(const base::Vec3& x) const;
  /// Of the crack at its present front, where that is nearest to x.
  [[nodiscard]] base::Vec3 normal_at_front(const base::Vec3& x) const;
  /// Of a place from the nearest front before the present one at which the crack turns by more
  /// than an angle [rad].
  [[nodiscard]] double distance_to_kink(const base::Vec3& x, double angle) const;
  /// The parts of these fronts, two points or more of each.
  [[nodiscard]] std::vector<std::vector<base::Vec3>> kink_lines(double angle) const;
  /// Behind how many of the fronts a place over the plane lies not: 0 behind the first.
  [[nodiscard]] std::size_t strip_number(const base::Vec3& x) const;

  [[nodiscard]] const PastAndPresentFronts& fronts() const { return fronts_; }
  /// The same crack elsewhere: points by `place`, directions by `direction`.
  using Map = std::function<base::Vec3(const base::Vec3&)>;
  /// The same crack surface elsewhere: points mapped by `place`, normals by `direction`.
  [[nodiscard]] NonPlanarCrackSurface transformed(const Map& place, const Map& direction) const;
  /// The box that holds all fronts.
  [[nodiscard]] const geometry::Box<3>& box() const { return box_; }
  /// The shortest way of the crack from one front to the next, where it is longest.
  [[nodiscard]] double narrowest_strip_width() const { return narrowest_; }

private:
  struct StripTriangle {
    base::Vec3 x0;    ///< a corner
    base::Vec3 slope; ///< in the plane
    std::size_t number = 0;
  };
  [[nodiscard]] base::Vec3 flat(const base::Vec3& x) const {
    return x - fronts_.normal.dot(x) * fronts_.normal;
  }
  [[nodiscard]] bool behind_first(const base::Vec3& q) const;
  void add(const base::Vec3& a, const base::Vec3& b, const base::Vec3& c);
  void rule(std::vector<base::Vec3> a, std::vector<base::Vec3> b);
  void go_on_before();
  void find_bends();

  PastAndPresentFronts fronts_;
  std::vector<StripTriangle> strips_;        ///< [triangle]
  std::vector<geometry::CornerPlaces> flat_; ///< [triangle] in the plane
  std::size_t number_ = 1;                   ///< of the strip that is made
  geometry::TriangleTree tree_{{}};          ///< of these
  std::vector<std::vector<double>> turned_;  ///< [front before the last][point] angle [rad]
  geometry::Box<3> box_;                     ///< of the fronts
  double narrowest_ = 0.0;
};

} // namespace spricka::mesh
