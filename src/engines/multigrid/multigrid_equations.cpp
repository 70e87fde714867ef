// SPDX-License-Identifier: GPL-3.0-or-later
#include "engines/multigrid/multigrid_equations.hpp"
#include "base/index.hpp"
#include "solve/factor_checks.hpp"
#include "solve/multigrid_law.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <new>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>

namespace spricka::engines {

using base::at;
using base::index;

namespace {

// In the norm of the strain energy, (solve.60): stress intensity factors and reactions, as products
// of two solutions, are then good to about as much.
constexpr double promised_error = 1e-8;
// Those that others are combined of are better than what is promised of these.
constexpr double error_of_expected_loads = 0.1 * promised_error;
// What a body costs that takes more is no better than a factor out of core.
constexpr int most_iterations = 1000;
// Later loads may be worse than those that the engine was judged by.
constexpr int most_iterations_later = 10 * most_iterations;
// Solutions from which others start: each is kept.
constexpr Eigen::Index most_expected_loads = 8;

} // namespace

MultigridEquations::MultigridEquations(base::SymmetricCsc& K, std::int64_t externals,
                                       const solve::CondensationSettings& settings)
    : n_(K.n), externals_(externals) {
  report_ = solve::estimate_multigrid(K, externals, settings, nullptr);
  report_.flops = 0.0;
  report_.relative_error = promised_error; // what takes more iterations goes on, or is no answer
  if (report_.status != solve::FactorStatus::ok || !is_possible(K, settings)) {
    return;
  }
  const double begun = solve::thread_cpu_seconds();
  try {
    set_up(K, settings);
    report_.analysis_cpu = solve::thread_cpu_seconds() - begun;
    if (locals() > 0) {
      solve_expected_loads(settings);
    }
    if (report_.status == solve::FactorStatus::ok) {
      form_schur();
    }
  } catch (const std::bad_alloc&) {
    report_.status = solve::FactorStatus::out_of_memory;
  } catch (const std::runtime_error& trouble) {
    report_.status = solve::FactorStatus::engine_failed;
    report_.trouble = trouble.what();
  }
  report_.numeric_cpu = solve::thread_cpu_seconds() - begun - report_.analysis_cpu;
  if (report_.status != solve::FactorStatus::ok) {
    give_back(K);
  }
}

bool MultigridEquations::is_possible(const base::SymmetricCsc& K,
                                     const solve::CondensationSettings& settings) {
  if (report_.memory + report_.besides > report_.memory_left) {
    report_.status = solve::FactorStatus::out_of_memory;
    return false;
  }
  if (settings.places == nullptr || settings.places->position.rows() != 3) {
    report_.status = solve::FactorStatus::engine_failed;
    report_.trouble = settings.places == nullptr
                          ? "multigrid does not solve nets of parts that are condensed first"
                          : "multigrid solves bodies in space only";
    return false;
  }
  assert(settings.places->node.size() == at(K.n));
  return true;
}

void MultigridEquations::set_up(base::SymmetricCsc& K,
                                const solve::CondensationSettings& settings) {
  coupling_ = ExternalCoupling(K, locals());
  if (locals() == 0) {
    K = base::SymmetricCsc();
    return;
  }
  K_.emplace(K, locals(), *settings.places);
  K = base::SymmetricCsc();
  multigrid_.emplace(*K_);
  iteration_.emplace(
      [this](const base::Vector& x, base::Vector& y) { K_->multiply(x.data(), y.data()); },
      [this](const base::Vector& r, base::Vector& z) { multigrid_->apply(r, z); });
}

IterationResult MultigridEquations::iterate(const base::Vector& b, const IterationGoal& goal,
                                            double& smallest_eigenvalue, base::Vector& u) const {
  const IterationResult result = iteration_->solve(b, goal, smallest_eigenvalue, u);
  const std::scoped_lock lock(record_);
  report_.flops += result.iterations * solve::flops_of_iteration(report_.factor_entries);
  return result;
}

// They tell what this body takes, and whether it is held. Where none is known, a load that moves
// all of it shows that.
void MultigridEquations::solve_expected_loads(const solve::CondensationSettings& settings) {
  std::vector<base::Vector> loads;
  const Eigen::Index given = settings.loads == nullptr ? 0 : settings.loads->cols();
  for (Eigen::Index k = 0; k < given && index(loads.size()) < most_expected_loads; ++k) {
    const auto load = settings.loads->col(k).head(locals());
    if (!load.isZero(0.0)) {
      loads.push_back(K_->by_node(load));
    }
  }
  const bool known = !loads.empty();
  if (!known) {
    base::Vector load(locals());
    for (std::int64_t i = 0; i < locals(); ++i) {
      load[i] = 1.0 + 0.25 * static_cast<double>(i % 7);
    }
    loads.push_back(K_->by_node(load));
  }
  IterationGoal goal{.relative_error = known ? error_of_expected_loads : std::sqrt(promised_error),
                     .most_iterations = known ? most_iterations : most_iterations / 2};
  base::Vector Ku(loads.front().size());
  for (const base::Vector& load : loads) {
    base::Vector u = start_.nearest(load);
    const IterationResult result = iterate(load, goal, smallest_eigenvalue_, u);
    if (result.status != IterationStatus::converged) {
      refuse(result, u);
      return;
    }
    K_->multiply(u.data(), Ku.data());
    start_.add(u, Ku);
  }
}

void MultigridEquations::refuse(const IterationResult& result, const base::Vector& u) {
  if (result.status == IterationStatus::not_positive_definite) {
    report_.status = solve::FactorStatus::not_positive_definite;
    report_.smallest_pivot = 0.0;
    // What nothing holds moves most.
    K_->by_unknown(u).cwiseAbs().maxCoeff(&report_.failed_row);
    return;
  }
  report_.status = solve::FactorStatus::engine_failed;
  report_.trouble =
      fmt::format("conjugate gradients with multigrid take more than {} iterations (a part that "
                  "hardly anything holds, or very flat elements)",
                  most_iterations);
}

base::Vector MultigridEquations::solve_locals(const base::Vector& b) const {
  const base::Vector load = K_->by_node(b);
  base::Vector u = start_.nearest(load);
  double smallest = smallest_eigenvalue_; // of each solution its own: bits hang on no order of them
  const IterationResult result =
      iterate(load, {.relative_error = promised_error, .most_iterations = most_iterations_later},
              smallest, u);
  if (result.status != IterationStatus::converged) {
    throw std::range_error(fmt::format(
        "conjugate gradients with multigrid do not converge: {} iterations, the error of the "
        "strain energy norm may be {:.1g} of it; choose --engine cholesky or mumps",
        result.iterations, result.relative_error));
  }
  return K_->by_unknown(u);
}

void MultigridEquations::form_schur() {
  S_ = coupling_.external_stiffness();
  if (locals() == 0) {
    return;
  }
  for (Eigen::Index j = 0; j < S_.cols(); ++j) {
    const base::Vector forces = coupling_.forces_on_locals(base::Vector::Unit(S_.cols(), j));
    if (!forces.isZero(0.0)) {
      S_.col(j) -= coupling_.forces_on_externals(solve_locals(forces));
    }
  }
  S_ = (0.5 * (S_ + S_.transpose())).eval();
}

void MultigridEquations::give_back(base::SymmetricCsc& K) {
  multigrid_.reset();
  iteration_.reset();
  start_ = StartSpace();
  if (!K_ || K.n > 0) {
    return;
  }
  const base::Matrix& K_ee = coupling_.external_stiffness();
  K.n = n_;
  K.start.assign(1, 0);
  for (std::int64_t j = 0; j < n_; ++j) {
    if (j < locals()) {
      K_->append_column(j, K.row, K.value);
      coupling_.append_column(j, K.row, K.value);
    }
    for (std::int64_t i = std::max(j, locals()); j >= locals() && i < n_; ++i) {
      if (const double value = K_ee(i - locals(), j - locals()); i == j || value != 0.0) {
        K.row.push_back(i);
        K.value.push_back(value);
      }
    }
    K.start.push_back(static_cast<std::int64_t>(K.row.size()));
  }
  K_.reset();
}

base::Matrix MultigridEquations::take_schur() {
  return std::exchange(S_, base::Matrix());
}

base::Matrix MultigridEquations::condense_load(const base::Matrix& f) const {
  assert(f.rows() == n_ && report_.status == solve::FactorStatus::ok);
  base::Matrix condensed = f.bottomRows(externals_);
  for (Eigen::Index k = 0; k < f.cols() && externals_ > 0 && locals() > 0; ++k) {
    condensed.col(k) -= coupling_.forces_on_externals(solve_locals(f.col(k).head(locals())));
  }
  return condensed;
}

base::Matrix
MultigridEquations::solve(const base::Matrix& f,
                          const solve::ExternalDisplacementSolver& displacement) const {
  assert(f.rows() == n_ && report_.status == solve::FactorStatus::ok);
  base::Matrix u(n_, f.cols());
  for (Eigen::Index k = 0; k < f.cols() && locals() > 0; ++k) {
    u.col(k).head(locals()) = solve_locals(f.col(k).head(locals()));
  }
  if (externals_ == 0) {
    return u;
  }
  base::Matrix condensed = f.bottomRows(externals_);
  for (Eigen::Index k = 0; k < f.cols() && locals() > 0; ++k) {
    condensed.col(k) -= coupling_.forces_on_externals(u.col(k).head(locals()));
  }
  u.bottomRows(externals_) = displacement(condensed);
  for (Eigen::Index k = 0; k < f.cols() && locals() > 0; ++k) {
    u.col(k).head(locals()) -= solve_locals(coupling_.forces_on_locals(u.col(k).tail(externals_)));
  }
  return u;
}

solve::RowCompliance
MultigridEquations::compliance_with_externals_held(solve::SparseRightHandSides F) const {
  assert(report_.status == solve::FactorStatus::ok);
  const std::int64_t count = F.count();
  const auto for_entries = [&](std::int64_t column, const auto& use) {
    for (std::int64_t p = F.start[at(column)]; p < F.start[at(column) + 1]; ++p) {
      use(F.row[at(p)], F.value[at(p)]);
    }
  };
  solve::RowCompliance out;
  out.W = base::Matrix::Zero(count, count);
  out.condensed = base::Matrix::Zero(externals_, count);
  const double flops = report_.flops;
  for (std::int64_t k = 0; k < count; ++k) {
    base::Vector column = base::Vector::Zero(n_);
    for_entries(k, [&](std::int64_t row, double value) { column[row] += value; });
    out.condensed.col(k) = column.tail(externals_);
    if (locals() == 0) {
      continue;
    }
    const base::Vector u = solve_locals(column.head(locals()));
    out.condensed.col(k) -= coupling_.forces_on_externals(u);
    for (std::int64_t other = 0; other < count; ++other) {
      for_entries(other, [&](std::int64_t row, double value) {
        out.W(other, k) += row < locals() ? value * u[row] : 0.0;
      });
    }
  }
  out.W = (0.5 * (out.W + out.W.transpose())).eval();
  out.flops = report_.flops - flops;
  return out;
}

} // namespace spricka::engines
