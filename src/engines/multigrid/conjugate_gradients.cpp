// SPDX-License-Identifier: GPL-3.0-or-later
#include "engines/multigrid/conjugate_gradients.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include <Eigen/Eigenvalues>

namespace spricka::engines {

namespace {

// The residual that is carried along parts from the true one by round-off; then it starts anew from
// there. More often would not help.
constexpr int most_restarts = 3;

// A matrix whose least eigenvalue is round-off of the preconditioned one is as good as singular.
constexpr double least_allowed_eigenvalue = 64.0 * std::numeric_limits<double>::epsilon();

} // namespace

/// The tridiagonal matrix of the process, whose eigenvalues approach those of M^-1 A.
struct ConjugateGradients::Lanczos {
  std::vector<double> diagonal, beside;

  void add(double step, double last_step, double last_ratio) {
    if (!diagonal.empty()) {
      beside.push_back(std::sqrt(last_ratio) / last_step);
    }
    diagonal.push_back(1.0 / step + (diagonal.empty() ? 0.0 : last_ratio / last_step));
  }

  [[nodiscard]] double smallest_eigenvalue() const {
    const auto n = static_cast<Eigen::Index>(diagonal.size());
    if (n < 2) {
      return n == 0 ? 1.0 : diagonal.front();
    }
    Eigen::SelfAdjointEigenSolver<base::Matrix> values;
    values.computeFromTridiagonal(Eigen::Map<const base::Vector>(diagonal.data(), n),
                                  Eigen::Map<const base::Vector>(beside.data(), n - 1),
                                  Eigen::EigenvaluesOnly);
    return values.eigenvalues().minCoeff();
  }
};

IterationResult ConjugateGradients::iterate(const base::Vector& b, const IterationGoal& goal,
                                            double& smallest_eigenvalue, base::Vector& u) const {
  base::Vector r(b.size());
  base::Vector z(b.size());
  base::Vector Ap(b.size());
  IterationResult result;
  multiply_(u, r);
  r = b - r;
  precondition_(r, z);
  base::Vector p = z;
  double rz = r.dot(z);
  double energy = u.dot(b);
  const auto bound = [&] {
    return rz <= 0.0 ? 0.0 : std::sqrt(rz / (smallest_eigenvalue * std::abs(energy)));
  };
  Lanczos lanczos;
  double last_step = 1.0;
  double last_ratio = 0.0;
  while (!((result.relative_error = bound()) <= goal.relative_error)) {
    if (result.iterations == goal.most_iterations) {
      result.status = IterationStatus::too_many_iterations;
      return result;
    }
    multiply_(p, Ap);
    const double curvature = p.dot(Ap);
    // Written so that what is not a number is refused.
    if (!(curvature > 0.0) || !(rz > 0.0)) {
      result.status = IterationStatus::not_positive_definite;
      return result;
    }
    const double step = rz / curvature;
    u += step * p;
    r -= step * Ap;
    energy = u.dot(b);
    precondition_(r, z);
    const double next = r.dot(z);
    lanczos.add(step, last_step, last_ratio);
    last_step = step;
    last_ratio = next / rz;
    rz = next;
    p = z + last_ratio * p;
    ++result.iterations;
    if (bound() <= goal.relative_error || result.iterations % 64 == 0) {
      // Ritz values come down: the bound is taken with the least there is now.
      smallest_eigenvalue = std::min(smallest_eigenvalue, lanczos.smallest_eigenvalue());
      if (!(smallest_eigenvalue > least_allowed_eigenvalue)) {
        result.status = IterationStatus::not_positive_definite;
        return result;
      }
    }
  }
  return result;
}

IterationResult ConjugateGradients::solve(const base::Vector& b, const IterationGoal& goal,
                                          double& smallest_eigenvalue, base::Vector& u) const {
  IterationResult all;
  if (b.isZero(0.0)) {
    u.setZero();
    return all;
  }
  // A pass that has nothing to do has measured the residual as it is.
  for (int pass = 0; pass <= most_restarts; ++pass) {
    const IterationResult part = iterate(b,
                                         {.relative_error = goal.relative_error,
                                          .most_iterations = goal.most_iterations - all.iterations},
                                         smallest_eigenvalue, u);
    all = {.status = part.status,
           .iterations = all.iterations + part.iterations,
           .relative_error = part.relative_error};
    if (part.status != IterationStatus::converged || part.iterations == 0) {
      return all;
    }
  }
  all.status = IterationStatus::too_many_iterations;
  return all;
}

} // namespace spricka::engines
