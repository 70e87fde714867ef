// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/cut/rosette.hpp"

#include <array>
#include <cassert>
#include <cmath>
#include <numbers>

namespace spricka::mesh {
namespace {

/// Radii of the rings of a rosette, tip first: thicknesses grow geometrically from `size`.
std::vector<double> ring_radii(double size, double radius, int rings) {
  // Bisection for the factor that fills the radius (crack.17): the sum grows with it.
  double low = 0.0;
  double high = radius / size; // (radius/size)^(rings-1) alone is enough
  for (int i = 0; i < 200 && rings > 1; ++i) {
    const double q = 0.5 * (low + high);
    (geometric_ring_sum(rings, q) * size < radius ? low : high) = q;
  }
  std::vector<double> r;
  double thickness = size;
  double at = 0.0;
  for (int k = 0; k < rings; ++k) {
    at += thickness;
    thickness *= low;
    r.push_back(at);
  }
  // The rim stands where the crack's line ends, without the round-off of the sum.
  r.back() = radius;
  return r;
}

} // namespace

Rosette add_rosette(PatchMeshBuilder& net, const CrackPlacement& placement, const PlacedTip& at,
                    const TipMeshParameters& tip) {
  constexpr double pi = std::numbers::pi;
  const bool half = placement.half != 0;
  const auto sectors = static_cast<std::size_t>(half ? (tip.sectors + 1) / 2 : tip.sectors);
  const std::size_t rays = half ? sectors + 1 : sectors;
  // The first ray of a full circle is the crack. A half goes round anticlockwise: with the body on
  // the left from ahead to the crack, else from the crack to ahead.
  const double start = placement.half > 0 ? 0.0 : -pi;
  const double turn = half ? pi : 2.0 * pi;
  const std::vector<double> radii = ring_radii(placement.size, placement.radius, tip.rings);

  Rosette result;
  result.tip = net.add_node_at_local_position(base::embed_in_space(at.at));
  const bool backward = std::abs(at.direction) == pi; // along the axis, too
  std::vector<std::vector<int>> corner(radii.size(), std::vector<int>(rays));
  for (std::size_t k = 0; k < radii.size(); ++k) {
    for (std::size_t j = 0; j < rays; ++j) {
      const double t = start + turn * static_cast<double>(j) / static_cast<double>(sectors);
      const double angle = at.direction + t;
      // On the axis without the round-off of sine and cosine: a straight crack and the line of a
      // half stay on one line to the last bit.
      const bool axis =
          (at.direction == 0.0 || backward) &&
          (std::abs(t) < coordinate_tolerance || std::abs(std::abs(t) - pi) < coordinate_tolerance);
      const base::Vec2 unit =
          axis ? base::Vec2((std::abs(t) < coordinate_tolerance) != backward ? 1.0 : -1.0, 0.0)
               : base::Vec2(std::cos(angle), std::sin(angle));
      corner[k][j] = net.add_node_at_local_position(base::embed_in_space(at.at + radii[k] * unit));
    }
  }
  for (std::size_t j = 0; j < rays; ++j) {
    // (shape.13). The third edge, from ray to ray, gets its middle on the chord, as (shape.14)
    // needs.
    const double part = tip.quarter_point ? 0.25 : 0.5;
    const base::Vec3& x = net.position(result.tip);
    const base::Vec3 quarter = x + part * (net.position(corner[0][j]) - x);
    net.set_mid_node(result.tip, corner[0][j], net.add_node_at_position(quarter));
  }
  for (std::size_t j = 0; j < sectors; ++j) {
    const std::size_t next = (j + 1) % rays;
    net.add_element(base::ElementType::trimc6,
                    std::array{result.tip, corner[0][j], corner[0][next]});
    for (std::size_t k = 1; k < radii.size(); ++k) {
      net.add_element(base::ElementType::quamc8, std::array{corner[k - 1][j], corner[k][j],
                                                            corner[k][next], corner[k - 1][next]});
    }
  }
  result.rim = corner.back();
  const std::size_t behind = placement.half > 0 ? sectors : 0;
  for (const std::vector<int>& ring : corner) {
    result.behind.push_back(ring[behind]);
    if (half) {
      result.ahead.push_back(ring[sectors - behind]);
    }
  }
  return result;
}

} // namespace spricka::mesh
