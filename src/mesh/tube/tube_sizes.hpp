// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "mesh/front_curve.hpp"
#include "mesh/tube/solid_crack.hpp"

#include <array>
#include <functional>
#include <vector>

namespace spricka::mesh {

/// Radius of the tube and length of its elements along a front, by what is there: at equal steps
/// of its length.
struct TubeSizes {
  std::vector<double> s;
  std::vector<double> radius;
  std::vector<double> length;
  std::vector<double> room; ///< distance to what the tube must not reach

  [[nodiscard]] double radius_at(double at) const;
  /// Lengths along the front at which elements begin and end, of equal number for each length
  /// wanted; of an open front at least two elements, of a closed one its end is not repeated.
  [[nodiscard]] std::vector<double> stations(bool closed) const;
  /// Elements along the front up to each of `s`.
  [[nodiscard]] std::vector<double> numbers() const;
  [[nodiscard]] double count() const { return numbers().back(); } ///< of them in all
};

/// What limits a tube at a length along the front: distance from the surface of the body and from
/// other cracks, and how far the crack reaches backwards. And how far the ends of an open front
/// lean from the surface's normal (tangent of the angle).
struct TubeSizeLimits {
  std::function<double(double)> free;
  std::function<double(double)> width;
  std::array<double, 2> lean{};
  /// Distance to where a crack that has turned is bent; empty: nowhere.
  std::function<double(double)> straight = {};
};

/// Length along the front over which the shear of an end fades, `sheared` at most; its steepest
/// slope is 3/2 of the shear over it.
double shear_fade_length(double radius, double sheared, double front_length);

/// The sizes of section lengths: a tenth of the crack's width, half of the radius of curvature, 0.4
/// of the room and half of what is straight for the radius; elements as long as 0.15 and 0.25 of
/// the first two, and 0.5 to 3 radii, shorter towards the ends of an open front. Near leaning ends
/// the radius leaves room for the shear onto the surface where the front turns. Given sizes
/// (`given`, in the lengths of the curve) stand as they are, all divided by `finer`.
TubeSizes tube_sizes(const FrontCurve& curve, const TubeSizeLimits& room,
                     const TubeMeshParameters& given);

} // namespace spricka::mesh
