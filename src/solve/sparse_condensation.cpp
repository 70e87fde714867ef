// SPDX-License-Identifier: GPL-3.0-or-later
#include "solve/sparse_condensation.hpp"
#include "base/index.hpp"
#include "base/memory.hpp"
#include "solve/blas.hpp"
#include "solve/cholmod_session.hpp"
#include "solve/factor_checks.hpp"
#include "solve/factor_substitution.hpp"
#include "solve/factor_values.hpp"
#include "solve/supernodal_cholesky.hpp"
#include "solve/supernodes.hpp"

#include <algorithm>
#include <cassert>
#include <memory>
#include <new>
#include <optional>
#include <utility>
#include <vector>

namespace spricka::solve {

using base::at;

namespace {

/// Owns a CHOLMOD factor; freeing needs no more than a fresh session.
class Factor {
public:
  Factor() = default;
  explicit Factor(cholmod_factor* factor) : factor_(factor) {}
  ~Factor() {
    if (factor_ != nullptr) {
      CholmodSession session;
      cholmod_l_free_factor(&factor_, session.get());
    }
  }
  Factor(const Factor&) = delete;
  Factor& operator=(const Factor&) = delete;
  Factor& operator=(Factor&& other) noexcept {
    std::swap(factor_, other.factor_);
    return *this;
  }
  Factor(Factor&& other) noexcept : factor_(std::exchange(other.factor_, nullptr)) {}

  [[nodiscard]] cholmod_factor* get() const { return factor_; }
  [[nodiscard]] cholmod_factor* operator->() const { return factor_; }

private:
  cholmod_factor* factor_ = nullptr;
};

std::vector<double> diagonal_of(const base::SymmetricCsc& K) {
  std::vector<double> diagonal(at(K.n));
  for (std::int64_t j = 0; j < K.n; ++j) {
    diagonal[at(j)] = K.value[at(K.start[at(j)])];
  }
  return diagonal;
}

/// A: in the order of elimination, rows of a column in any order.
Factor analyse(const base::SymmetricCsc& A, CholmodSession& session) {
  // Locals have been postordered already, and externals must stay last.
  session->supernodal = CHOLMOD_SUPERNODAL;
  session->nmethods = 1;
  session->method[0].ordering = CHOLMOD_NATURAL;
  session->postorder = 0;
  session->final_ll = 1;
  cholmod_sparse view = cholmod_lower_view(A.n, A.start.data(), A.row.data(), nullptr);
  view.sorted = 0;
  return Factor(cholmod_l_analyze_p(&view, nullptr, nullptr, 0, session.get()));
}

} // namespace

struct SparseCondensation::Impl {
  FactorReport report;
  std::int64_t n = 0;
  std::int64_t locals = 0;
  base::SymmetricCsc matrix;       ///< K until its factorisation is certain to begin
  std::vector<double> diagonal;    ///< of K
  std::vector<std::int64_t> order; ///< [n] row of K at each position of the elimination
  /// K in this order until its entries are in the factor. The first external column is full: then
  /// the block of externals is from its first column on and becomes one supernode.
  base::SymmetricCsc ordered;
  Factor factor; ///< its symbolic part
  std::optional<FactorPanels> panels;
  FactorValues values;
  base::Matrix S;
  int threads = 1; ///< that work on it

  void build(const CondensationSettings& settings);
  void analyse_pattern(const base::SymmetricCsc& K, OrderingMethod ordering);
  void factorise();
  void check_pivots();
  void read_schur();
  void drop_externals();
  void to_elimination(SparseRightHandSides& F) const;
  void count_rows(SparseRightHandSides rows);

  [[nodiscard]] FactorSubstitution substitution() const { return {*panels, values.get(), threads}; }
  [[nodiscard]] SupernodalFactor supernodes() const {
    const auto integers = [](void* p) { return static_cast<const std::int64_t*>(p); };
    return {.n = n,
            .locals = locals,
            .count = static_cast<std::int64_t>(factor->nsuper),
            .column = integers(factor->super),
            .row_start = integers(factor->pi),
            .value_start = integers(factor->px),
            .row = integers(factor->s),
            .value = values.get()};
  }
};

void SparseCondensation::Impl::analyse_pattern(const base::SymmetricCsc& K,
                                               OrderingMethod ordering) {
  const double started = thread_cpu_seconds();
  CholmodSession session;
  order = elimination_order(K, locals, ordering);
  ordered = reorder(K, order, locals);
  factor = analyse(ordered, session);
  report.analysis_cpu = thread_cpu_seconds() - started;
  if (factor.get() == nullptr) {
    report.status = FactorStatus::out_of_memory;
    return;
  }
  const double externals = static_cast<double>(n - locals);
  report.flops = session->fl;
  report.factor_entries = session->lnz;
  report.kept_memory = 8.0 * static_cast<double>(factor->xsize + factor->ssize);
  // The factor, and on top of it, one after the other, the matrix in the order of elimination and
  // the condensed one.
  report.memory = report.kept_memory +
                  std::max(16.0 * static_cast<double>(K.row.size()), 8.0 * externals * externals);
}

void SparseCondensation::Impl::build(const CondensationSettings& settings) {
  blas::force_single_blas_thread();
  diagonal = diagonal_of(matrix);
  analyse_pattern(matrix, settings.ordering);
  if (report.status != FactorStatus::ok) {
    return;
  }
  if (report.flops > settings.most_flops) {
    report.status = FactorStatus::engine_failed;
    return;
  }
  // Refused before any more of it is asked for: a machine that swaps is no help.
  const double there =
      16.0 * static_cast<double>(matrix.row.size()); // of what report.memory counts
  report.memory_left = base::available_memory() + there;
  if (report.memory + report.besides > report.memory_left) {
    report.status = FactorStatus::out_of_memory;
    return;
  }
  factorise();
  const double factorised = thread_cpu_seconds();
  if (report.status == FactorStatus::ok) {
    check_pivots();
  }
  if (report.status == FactorStatus::ok) {
    read_schur();
  }
  report.numeric_cpu += thread_cpu_seconds() - factorised;
}

void SparseCondensation::Impl::factorise() {
  const double started = thread_cpu_seconds();
  // Asked for while K is still there to be given back; used from the first panel on.
  values.resize(factor->xsize);
  matrix = base::SymmetricCsc();
  panels.emplace(supernodes());
  SupernodalCholesky factorisation(*panels, values.get(), ordered);
  report.numeric_cpu = thread_cpu_seconds() - started;
  const std::int64_t bad = factorisation.factorise(threads);
  ordered = base::SymmetricCsc();
  report.numeric_cpu += factorisation.cpu_seconds();
  if (bad < n) {
    report.status = FactorStatus::not_positive_definite;
    report.failed_row = order[at(bad)];
    report.smallest_pivot = 0.0;
  }
}

void SparseCondensation::Impl::check_pivots() {
  const SupernodalFactor L = supernodes();
  std::int64_t weakest = -1;
  for (std::int64_t s = 0; s < L.count; ++s) {
    const std::int64_t rows = L.row_start[s + 1] - L.row_start[s];
    // (solve.7) for locals alone: externals are not eliminated.
    for (std::int64_t j = L.column[s]; j < std::min(L.column[s + 1], locals); ++j) {
      const double pivot = L.value[L.value_start[s] + (j - L.column[s]) * (rows + 1)];
      const double ratio = pivot * pivot / diagonal[at(order[at(j)])];
      // Written so that a pivot that is not a number counts as the weakest.
      if (!(ratio >= report.smallest_pivot)) {
        report.smallest_pivot = ratio;
        weakest = j;
      }
    }
  }
  if (weakest >= 0 && !(report.smallest_pivot > smallest_allowed_pivot(n))) {
    report.status = FactorStatus::not_positive_definite;
    report.failed_row = order[at(weakest)];
  }
}

void SparseCondensation::Impl::read_schur() {
  // The supernodes of externals hold what elimination of the locals has left of K_ee.
  S = trailing_block(supernodes());
  drop_externals();
  S.triangularView<Eigen::StrictlyUpper>() = S.transpose();
}

/// Gives back the memory of the supernodes that hold externals only; the half solves of the locals
/// never look at them.
void SparseCondensation::Impl::drop_externals() {
  const SupernodalFactor L = supernodes();
  std::int64_t s = L.count;
  while (s > 0 && L.column[s - 1] >= locals) {
    --s;
  }
  const std::size_t kept = std::max<std::size_t>(at(L.value_start[s]), 1);
  if (s < L.count) {
    values.resize(kept);
  }
}

/// Rows of F as those of the elimination.
void SparseCondensation::Impl::to_elimination(SparseRightHandSides& F) const {
  std::vector<std::int64_t> position(at(n));
  for (std::int64_t k = 0; k < n; ++k) {
    position[at(order[at(k)])] = k;
  }
  for (std::int64_t& row : F.row) {
    row = position[at(row)];
  }
}

void SparseCondensation::Impl::count_rows(SparseRightHandSides rows) {
  to_elimination(rows);
  const SupernodalFactor L = supernodes();
  const RowElimination elimination(L, rows);
  report.row_flops = elimination.flops();
  report.row_memory = elimination.workspace();
}

SparseCondensation::SparseCondensation(base::SymmetricCsc K, std::int64_t externals,
                                       const CondensationSettings& settings)
    : impl_(std::make_unique<Impl>()) {
  impl_->report.besides = settings.besides;
  impl_->report.engine_reason = settings.engine_reason;
  impl_->threads = settings.threads;
  assert(externals >= 0 && externals <= K.n);
  impl_->n = K.n;
  impl_->locals = K.n - externals;
  if (K.n == 0) {
    return;
  }
  impl_->matrix = std::move(K);
  try {
    impl_->build(settings);
  } catch (const std::bad_alloc&) {
    impl_->report.status = FactorStatus::out_of_memory;
  }
  if (impl_->report.status != FactorStatus::ok) {
    impl_->factor = Factor();
    impl_->ordered = base::SymmetricCsc();
    impl_->values = FactorValues();
    impl_->S = base::Matrix();
  }
  if (impl_->report.status == FactorStatus::ok ||
      impl_->report.status == FactorStatus::not_positive_definite) {
    impl_->matrix = base::SymmetricCsc();
    impl_->diagonal = {};
  }
}

base::SymmetricCsc SparseCondensation::give_back_matrix() {
  return std::exchange(impl_->matrix, {});
}

FactorReport SparseCondensation::forecast(const base::SymmetricCsc& pattern, std::int64_t externals,
                                          const CondensationSettings& settings,
                                          const SparseRightHandSides* rows) {
  assert(externals >= 0 && externals <= pattern.n);
  Impl impl;
  impl.n = pattern.n;
  impl.locals = pattern.n - externals;
  if (pattern.n > 0) {
    try {
      impl.analyse_pattern(pattern, settings.ordering);
      if (rows != nullptr && impl.report.status == FactorStatus::ok) {
        impl.count_rows(*rows);
      }
    } catch (const std::bad_alloc&) {
      impl.report.status = FactorStatus::out_of_memory;
    }
  }
  return impl.report;
}

SparseCondensation::~SparseCondensation() = default;

const FactorReport& SparseCondensation::report() const {
  return impl_->report;
}

base::Matrix SparseCondensation::take_schur() {
  return std::exchange(impl_->S, base::Matrix());
}

base::Matrix SparseCondensation::condense_load(const base::Matrix& f) const {
  const Impl& c = *impl_;
  assert(f.rows() == c.n && c.report.status == FactorStatus::ok);
  if (c.n == c.locals) {
    return {0, f.cols()}; // no external to hand anything to
  }
  base::Matrix X(c.n, f.cols());
  for (std::int64_t k = 0; k < c.n; ++k) {
    X.row(k) = f.row(c.order[at(k)]);
  }
  c.substitution().forward(X);
  return X.bottomRows(c.n - c.locals);
}

base::Matrix SparseCondensation::solve(const base::Matrix& f,
                                       const ExternalDisplacementSolver& displacement) const {
  const Impl& c = *impl_;
  assert(f.rows() == c.n && c.report.status == FactorStatus::ok);
  if (c.n == 0) {
    return f;
  }
  base::Matrix X(c.n, f.cols());
  for (std::int64_t k = 0; k < c.n; ++k) {
    X.row(k) = f.row(c.order[at(k)]);
  }
  c.substitution().forward(X);
  if (c.n > c.locals) {
    // (solve.6): the forward half has left y_l above.
    const base::Matrix u_external = displacement(X.bottomRows(c.n - c.locals));
    X.bottomRows(c.n - c.locals) = u_external;
  }
  c.substitution().backward(X);
  base::Matrix u(c.n, f.cols());
  for (std::int64_t k = 0; k < c.n; ++k) {
    u.row(c.order[at(k)]) = X.row(k);
  }
  return u;
}

RowCompliance SparseCondensation::compliance_with_externals_held(SparseRightHandSides F) const {
  const Impl& c = *impl_;
  assert(c.report.status == FactorStatus::ok);
  c.to_elimination(F);
  RowCompliance out;
  out.condensed = base::Matrix::Zero(c.n - c.locals, base::index(F.count()));
  for (std::int64_t k = 0; k < F.count(); ++k) {
    for (std::int64_t p = F.start[at(k)]; p < F.start[at(k + 1)]; ++p) {
      if (F.row[at(p)] >= c.locals) {
        out.condensed(F.row[at(p)] - c.locals, k) += F.value[at(p)];
      }
    }
  }
  const SupernodalFactor L = c.supernodes();
  RowElimination elimination(L, F);
  out.flops = elimination.flops();
  out.W = elimination.compute_compliance(out.condensed, c.threads);
  return out;
}

double SparseCondensation::compliance_memory(SparseRightHandSides F) const {
  const Impl& c = *impl_;
  assert(c.report.status == FactorStatus::ok);
  c.to_elimination(F);
  const SupernodalFactor L = c.supernodes();
  const auto k = static_cast<double>(F.count());
  const double result = k * (k + static_cast<double>(c.n - c.locals));
  return RowElimination(L, F).workspace() + sizeof(double) * result;
}

} // namespace spricka::solve
