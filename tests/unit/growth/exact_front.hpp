// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "mesh/front_curve.hpp"

#include <complex>

#include <Eigen/Core>

namespace spricka::test {

/// A plane crack of any smooth shape in an infinite body under a tension of 1, z = 0: its exact K1
/// and weight function, carried from a circle on by Rice's perturbations (tests/bench/free_front.py
/// has the formulas and their sources).
class ExactFront {
public:
  explicit ExactFront(int points);
  /// Becomes the crack with this front, which must lie about the origin and not far from the last.
  void move_to(const mesh::FrontCurve& curve);
  /// Becomes an ellipse with half-axes 1 along x and `ratio` along y.
  void flatten(double ratio);
  /// At the place of the front nearest to x.
  [[nodiscard]] double K_at(const base::Vec3& x) const;

private:
  using Complex = std::complex<double>;
  using Places = Eigen::VectorXcd;
  struct State {
    Places z;          ///< [point]
    Eigen::VectorXd K; ///< [point]
    Eigen::MatrixXd W; ///< times 1/(4 sin^2) of half of the parameters' difference: Z
  };
  [[nodiscard]] State rates(const State& at, const Places& velocity) const;
  template <class Velocity> void step(double h, const Velocity& velocity);

  State now_;
  Eigen::MatrixXd absolute_, hilbert_, slope_, cot_;
};

} // namespace spricka::test
