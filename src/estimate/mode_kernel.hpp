// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "estimate/modes.hpp"
#include "fe/element.hpp"

/// Kernels of one enriched element; nothing here allocates. The stiffness, which is hot, is
/// compiled in mode_kernel.cpp for each element that has modes, the rest takes the modes as data.
/// Mode m has two freedoms, rows 2 m and 2 m + 1 of an element matrix: along x and y, or, for sides
/// whose modes stand in the side's own frame, along its outer normal and its tangent (body on the
/// left).
namespace spricka::estimate {

template <shape::PlaneShape S> constexpr int mode_freedoms = 2 * Modes<S>::count;

/// One number for each mode freedom of an element.
using ModeNumbers = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, 2 * most_plane_modes, 1>;

/// Displacement gradients of all mode freedoms at a point: rows du_x/dx, du_x/dy, du_y/dx, du_y/dy.
using ModeGradients = Eigen::Matrix<double, 4, Eigen::Dynamic, 0, 4, 2 * most_plane_modes>;

/// Which sides of an element have modes in their own frame, and the signs of the side modes.
struct SideModeFrames {
  std::array<double, 4> sign{1.0, 1.0, 1.0, 1.0};
  std::array<bool, 4> framed{};

  [[nodiscard]] bool any_framed() const { return framed[0] || framed[1] || framed[2] || framed[3]; }
};

/// Outer normal and tangent of a side at t, and how they turn with t.
struct SideFrame {
  std::array<base::Vec2, 2> axis;  ///< normal, tangent
  std::array<base::Vec2, 2> slope; ///< d axis / dt
};

/// x: both ends and the middle of the side.
inline SideFrame side_frame(const std::array<base::Vec2, 3>& x, double t) {
  const base::Vec2 T = (t - 0.5) * x[0] + (t + 0.5) * x[1] - 2.0 * t * x[2];
  const base::Vec2 bend = x[0] + x[1] - 2.0 * x[2];
  const double length = T.norm();
  const base::Vec2 tau = T / length;
  const base::Vec2 turn = (bend - tau * tau.dot(bend)) / length;
  return {{base::Vec2(tau.y(), -tau.x()), tau}, {base::Vec2(turn.y(), -turn.x()), turn}};
}

/// Ends and middle of a side out of nodal coordinates.
inline std::array<base::Vec2, 3> side_node_coordinates(const PlaneModes& modes,
                                                       const fe::AnyNodeVectors<2>& X, int s) {
  return {X.col(s), X.col((s + 1) % modes.sides), X.col(modes.sides + s)};
}

/// Displacement gradients of all mode freedoms at r, by x and y. J: Jacobian of the map at r; X:
/// the element's nodes, asked for framed sides only.
ModeGradients mode_gradients(const PlaneModes& modes, const fe::AnyNodeVectors<2>& X,
                             const shape::Point<2>& r, const Eigen::Matrix2d& J,
                             const SideModeFrames& sides);

/// Displacements along x of all mode freedoms at a point: about an axis the strain round it is
/// these over x.
ModeNumbers mode_x_displacements(const PlaneModes& modes, const fe::AnyNodeVectors<2>& X,
                                 const shape::Point<2>& r, const SideModeFrames& sides);

/// Stiffness of the modes with themselves and with the nodes' displacements (manual, estimate.8).
template <shape::PlaneShape S> struct EnrichedStiffness {
  static constexpr int modes = Modes<S>::count;
  Eigen::Matrix<double, mode_freedoms<S>, mode_freedoms<S>> ee;
  Eigen::Matrix<double, mode_freedoms<S>, 2 * S::nodes> ep;

  EnrichedStiffness(const fe::NodeVectors<S>& X, const fe::ConstitutiveLaw& law,
                    const SideModeFrames& sides);

private:
  void by_strains(const fe::NodeVectors<S>& X, const fe::ConstitutiveLaw& law,
                  const SideModeFrames& sides);
  void about_axis(const fe::NodeVectors<S>& X, const fe::ConstitutiveLaw& law,
                  const SideModeFrames& sides);
  void by_moments(const fe::NodeVectors<S>& X, const fe::ConstitutiveLaw& law,
                  const SideModeFrames& sides);
};

} // namespace spricka::estimate
