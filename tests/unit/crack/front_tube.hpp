// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "crack/front_intensity.hpp"
#include "model/model.hpp"

#include <functional>
#include <vector>

/// A tube of quarter-point wedges and hexahedra round a front, cut along the crack: what a patch
/// has there, without what it is cut into.
namespace spricka::test {

struct TubeSpec {
  int segments = 8; ///< along the front
  int sectors = 8;
  std::vector<double> radii{0.1, 0.2, 0.3}; ///< of the rings of elements
  bool quarter_point = true;
  double nu = 0.3;
  /// Shift of an end section along the front at a place y, z across it: fronts that leave the body
  /// off its normal.
  double shear = 0.0;
};

struct Tube {
  model::Model model;
  mesh::CrackedMesh cracked;

  Tube(const mesh::FrontCurve& curve, const TubeSpec& spec);
  [[nodiscard]] const mesh::CrackFront& front() const { return cracked.fronts.front(); }
  [[nodiscard]] const model::Mesh& mesh() const { return cracked.mesh; }

  /// Nodal values [3 * node] of a displacement; `upper` and `lower` say which face of the crack a
  /// node lies on.
  using CardField = std::function<base::Vec3(const base::Vec3& x, crack::UpperOrLowerFace side)>;
  [[nodiscard]] base::Vector at_nodes(const CardField& u) const;
  /// Values without a pattern, a reproducible part of one.
  [[nodiscard]] base::Vector rough() const;
  [[nodiscard]] crack::FrontIntegralDomains fields(const std::vector<int>& rings = {1, 2}) const;
  [[nodiscard]] std::vector<crack::StressIntensity> K(const base::Vector& u,
                                                      const crack::FrontLoads& loads = {}) const;
};

/// The front from the origin along the z axis, m = x, b = y.
mesh::FrontCurve straight_front(double length);
/// Of a penny with radius a in z = 0, b = z; closed, or `part` of the round.
mesh::FrontCurve penny_front(double a, double part = 1.0);
/// Part of an ellipse with half axes p and q.
mesh::FrontCurve ellipse_front(double p, double q, double part);

/// Displacements of a penny of radius 1 in an infinite body: faces under a pressure of 1.
base::Vec3 pressed_penny(const base::Vec3& at, crack::UpperOrLowerFace side, double mu, double nu);
/// Under a remote shear s_xz of 1, faces free.
base::Vec3 sheared_penny(const base::Vec3& at, crack::UpperOrLowerFace side, double mu, double nu);

} // namespace spricka::test
