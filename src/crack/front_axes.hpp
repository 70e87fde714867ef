// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "crack/extension.hpp"
#include "mesh/front_curve.hpp"

#include <vector>

namespace spricka::crack {

/// A point as seen from the front: the axes at the place nearest to it, how these turn along the
/// front (first derivatives are the frame's, second ones here), and where it lies across.
struct FrontCoordinates {
  mesh::FrontFrame frame;
  base::Vec3 ddm = base::Vec3::Zero(); ///< d2m/ds2, d2b/ds2, d2t/ds2 [1/length^2]
  base::Vec3 ddb = base::Vec3::Zero();
  base::Vec3 ddt = base::Vec3::Zero();
  double y = 0.0, z = 0.0; ///< along m and b from the front
  double r = 0.0, theta = 0.0;
};

/// A value along a front and its derivatives by length.
template <class Value> struct InterpolatedValue { Value at, by_s, by_ss; };

/// Places along a front. Integrals ask for millions: axes are kept at stations, the knots of the
/// curve, and are cubic in between, so that their derivatives are exactly those of what is used.
/// Beyond an open end they go on turning as they do there, by a radian at most, then straight on:
/// where a front leans against the surface elements of its domains reach beyond its end, and a jump
/// of how the axes turn would be a load of the auxiliary fields that no integral has.
class FrontAxes {
public:
  explicit FrontAxes(const mesh::FrontCurve& curve);

  /// Coordinates of x in the section across the front through the nearest place of it. `side`: the
  /// crack face on which x lies, for the sign of theta.
  [[nodiscard]] FrontCoordinates locate_point(const base::Vec3& x,
                                              UpperOrLowerFace side = UpperOrLowerFace::none) const;

private:
  using Axes = Eigen::Matrix<double, 3, 4>; ///< x, m, b, t
  [[nodiscard]] std::size_t nearest_station(const base::Vec3& x) const;
  /// Between station i and the next, part: of the way, 0 to 1.
  [[nodiscard]] InterpolatedValue<Axes> turned(std::size_t i, double part) const;
  /// The place alone.
  [[nodiscard]] InterpolatedValue<base::Vec3> point(std::size_t i, double part) const;
  void go_on_beyond_ends();

  std::vector<double> s_;  ///< [station] ascending, of a closed front from 0 to its length
  std::vector<Axes> axes_; ///< [station]
  std::vector<Axes> turn_; ///< [station] derivatives by s
  bool closed_;
};

} // namespace spricka::crack
