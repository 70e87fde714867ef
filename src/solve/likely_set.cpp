// SPDX-License-Identifier: GPL-3.0-or-later
#include "solve/likely_set.hpp"
#include "base/index.hpp"
#include "solve/blas.hpp"

#include <algorithm>
#include <cmath>

namespace spricka::solve {

using base::at;

namespace {

constexpr int rounds = 12;         // each ends with a step of the modes
constexpr int steps_of_round = 15; // of the forces
constexpr int power_steps = 15;    // for the largest eigenvalue, which they find from below
constexpr double above = 1.1;

class Gradient {
public:
  explicit Gradient(const ControllableProblem& problem)
      : p_(problem),
        inverse_(problem.d.unaryExpr([](double d) { return d > 0.0 ? 1.0 / d : 0.0; })),
        B_(std::sqrt(problem.tau) * (inverse_.asDiagonal() * problem.B)),
        b_(inverse_.cwiseProduct(problem.b)), h_(std::sqrt(problem.tau) * problem.h),
        alpha_(base::Vector::Zero(problem.mode_count())) {}

  std::vector<bool> closed() {
    const double step = 1.0 / (above * largest_eigenvalue());
    base::Vector x = base::Vector::Zero(p_.rows());
    for (int round = 0; round < rounds; ++round) {
      base::Vector y = x;
      double t = 1.0;
      for (int k = 0; k < steps_of_round; ++k) {
        const base::Vector next = pushed(y - step * gap(y));
        // Momentum that leads uphill is dropped (O'Donoghue and Candes 2015).
        const bool uphill = (y - next).dot(next - x) > 0.0;
        const double faster = uphill ? 1.0 : 0.5 * (1.0 + std::sqrt(1.0 + 4.0 * t * t));
        y = uphill ? next : base::Vector(next + (t - 1.0) / faster * (next - x));
        x = next;
        t = faster;
      }
      alpha_ += h_ + B_.transpose() * x;
    }
    std::vector<bool> set(static_cast<std::size_t>(p_.rows()));
    for (int i = 0; i < p_.rows(); ++i) {
      set[at(i)] = p_.equality[at(i)] || x[i] > 0.0;
    }
    return set;
  }

private:
  [[nodiscard]] base::Vector compliance(const base::Vector& x) const {
    const base::Vector force = inverse_.cwiseProduct(x);
    base::Vector opened(p_.rows());
    blas::gemm({.m = p_.rows(), .n = 1, .k = p_.rows(), .beta = 0.0}, {p_.W.data(), p_.rows()},
               {force.data(), p_.rows()}, {opened.data(), p_.rows()});
    return inverse_.cwiseProduct(opened);
  }
  [[nodiscard]] base::Vector gap(const base::Vector& x) const {
    return b_ + compliance(x) + B_ * (alpha_ + h_ + B_.transpose() * x);
  }
  [[nodiscard]] base::Vector pushed(base::Vector x) const {
    for (int i = 0; i < p_.rows(); ++i) {
      x[i] = p_.equality[at(i)] ? x[i] : std::max(x[i], 0.0);
    }
    return x;
  }
  [[nodiscard]] double largest_eigenvalue() const {
    base::Vector x = base::Vector::Ones(p_.rows());
    double size = 1.0;
    for (int k = 0; k < power_steps; ++k) {
      x /= x.norm();
      x = compliance(x) + B_ * (B_.transpose() * x);
      size = x.norm();
    }
    return size;
  }

  const ControllableProblem& p_;
  base::Vector inverse_;
  base::Matrix B_;
  base::Vector b_, h_, alpha_;
};

} // namespace

std::vector<bool> predict_closed_rows(const ControllableProblem& problem) {
  return Gradient(problem).closed();
}

} // namespace spricka::solve
