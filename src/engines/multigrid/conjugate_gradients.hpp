// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/vec.hpp"

#include <functional>

namespace spricka::engines {

enum class IterationStatus { converged, not_positive_definite, too_many_iterations };

struct IterationResult {
  IterationStatus status = IterationStatus::converged;
  int iterations = 0;
  /// Bound of ||u - u_k||_A / ||u||_A, of the residual as it is at the end.
  double relative_error = 0.0;
};

struct IterationGoal {
  double relative_error = 1e-8; ///< in the norm of the strain energy
  int most_iterations = 1000;
};

/// Preconditioned conjugate gradients (Hestenes and Stiefel 1952) for a symmetric, positive
/// definite matrix A [n, n]. They stop by the error of the strain energy norm itself, not by a
/// residual:
/// ||u - u_k||_A^2 = r A^-1 r <= r M^-1 r / lambda, with lambda the smallest eigenvalue of M^-1 A
/// as the iterations have found it (its Ritz values; Meurant and Tichy 2019).
class ConjugateGradients {
public:
  using LinearMap = std::function<void(const base::Vector&, base::Vector&)>;
  ConjugateGradients(LinearMap multiply, LinearMap precondition)
      : multiply_(std::move(multiply)), precondition_(std::move(precondition)) {}

  /// Solves A u = b from the u [n] that is given. `smallest_eigenvalue` of M^-1 A: the least that
  /// was found so far, 1 at first; a solution that starts near its end finds none itself.
  IterationResult solve(const base::Vector& b, const IterationGoal& goal,
                        double& smallest_eigenvalue, base::Vector& u) const;

private:
  struct Lanczos;
  IterationResult iterate(const base::Vector& b, const IterationGoal& goal,
                          double& smallest_eigenvalue, base::Vector& u) const;

  LinearMap multiply_;
  LinearMap precondition_;
};

} // namespace spricka::engines
