// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/convergence/error_norm.hpp"

#include "fe/element.hpp"
#include "tests/unit/fe/plane_problem.hpp"

#include <cmath>

namespace spricka::test {

ErrorNorms error_norms(const model::Model& model, const base::Vector& u, const Exact& exact) {
  const model::Mesh& mesh = model.mesh;
  ErrorNorms square;
  fe::for_plane_blocks(mesh, every_element(mesh),
                       [&]<shape::PlaneShape S>(S, std::span<const base::ElementId> block) {
                         for (const base::ElementId e : block) {
                           const fe::NodeVectors<S> X = fe::coordinates<S>(mesh, e);
                           const fe::NodeVectors<S> U = fe::gather<S>(mesh, e, u);
                           const fe::Elasticity<2> D = fe::elasticity<2>(
                               model.material_of(mesh, e), model.property_of(mesh, e).state);
                           for (const auto& point : shape::quadrature<S>(10)) {
                             const fe::Jacobian<S> at = fe::jacobian<S>(X, point.r);
                             const Eigen::Vector2d x = X * S::N(point.r);
                             const Eigen::Matrix2d H = exact.H(x) - U * at.dNdx;
                             const fe::Strain<2> eps = fe::strain<2>(H);
                             const double w = point.weight * at.det;
                             square.L2 += w * (exact.u(x) - U * S::N(point.r)).squaredNorm();
                             square.energy += w * eps.dot(D * eps);
                           }
                         }
                       });
  return {std::sqrt(square.L2), std::sqrt(square.energy)};
}

double slope(const std::vector<double>& errors) {
  const auto n = static_cast<double>(errors.size());
  double sx = 0.0;
  double sy = 0.0;
  double sxx = 0.0;
  double sxy = 0.0;
  for (std::size_t i = 0; i < errors.size(); ++i) {
    const double x = -std::log(2.0) * static_cast<double>(i);
    const double y = std::log(errors[i]);
    sx += x;
    sy += y;
    sxx += x * x;
    sxy += x * y;
  }
  return (n * sxy - sx * sy) / (n * sxx - sx * sx);
}

} // namespace spricka::test
