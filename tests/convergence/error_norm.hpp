// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/vec.hpp"
#include "model/forward.hpp"

#include <functional>
#include <vector>

namespace spricka::test {

/// An exact plane solution: displacement and its gradient du_i/dx_j.
struct Exact {
  std::function<Eigen::Vector2d(const Eigen::Vector2d&)> u;
  std::function<Eigen::Matrix2d(const Eigen::Vector2d&)> H;
};

/// An exact solution in the plane, about an axis (x radius, y axis; z unused) or in space.
struct ExactField {
  std::function<base::Vec3(const base::Vec3&)> u;
  std::function<Eigen::Matrix3d(const base::Vec3&)> H; ///< without the hoop strain
};

/// Errors of a nodal vector against an exact solution, integrated over model.mesh.
struct ErrorNorms {
  double L2 = 0.0;     ///< of the displacement
  double energy = 0.0; ///< sqrt of the integral of (eps - eps_h) D (eps - eps_h)
};
ErrorNorms error_norms(const model::Model& model, const base::Vector& u, const ExactField& exact);
ErrorNorms error_norms(const model::Model& model, const base::Vector& u, const Exact& exact);

/// Slope of log(error) over log(h) by least squares, h halved from one entry to the next.
double slope(const std::vector<double>& errors);
/// The same for meshes of n[i] elements along each side.
double slope(const std::vector<int>& n, const std::vector<double>& errors);

} // namespace spricka::test
