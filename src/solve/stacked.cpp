// SPDX-License-Identifier: GPL-3.0-or-later
#include "solve/stacked.hpp"
#include "base/index.hpp"
#include "solve/blas.hpp"
#include "solve/dense_cholesky.hpp"
#include "solve/engine_choice.hpp"
#include "solve/factor_checks.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace spricka::solve {

using base::at;
using base::index;

namespace {

// Cholesky column by column, to find the row where it stops.
Eigen::Index first_bad_pivot(base::Matrix A) {
  for (Eigen::Index j = 0; j < A.rows(); ++j) {
    const double pivot = A(j, j) - A.row(j).head(j).squaredNorm();
    if (!(pivot > 0.0)) {
      return j;
    }
    A(j, j) = std::sqrt(pivot);
    for (Eigen::Index i = j + 1; i < A.rows(); ++i) {
      A(i, j) = (A(i, j) - A.row(i).head(j).dot(A.row(j).head(j))) / A(j, j);
    }
  }
  // In another order of sums round-off may let every pivot pass: then the last row is named.
  return A.rows() - 1;
}

} // namespace

FactorReport TwoLevelCondensation::forecast(const base::SymmetricCsc& K, std::int64_t externals,
                                            std::span<const CondensedNetBlock> blocks,
                                            const CondensationSettings& settings,
                                            EarlyLateRowPartition* early) {
  TwoLevelRows rows = divide_rows_by_level(K, externals, blocks);
  FactorReport report = forecast_equations(
      lower_level_matrix(K, rows), static_cast<std::int64_t>(rows.touched.size()), settings);
  bool kept = false;
  if (early != nullptr) {
    find_externals_of_block_alone(K, blocks, rows);
    if (!rows.early.empty()) {
      EarlyLateRowPartition lists = partition_block(rows, blocks.front());
      // The factor of early rows is kept for the next length only if it has the same rows of the
      // block.
      kept = lists == *early;
      *early = std::move(lists);
    }
  }
  add_upper_level_cost(rows, kept, report);
  return report;
}

TwoLevelCondensation::TwoLevelCondensation(const base::SymmetricCsc& K, std::int64_t externals,
                                           std::span<const CondensedNetBlock> blocks,
                                           std::shared_ptr<const FirstBlockFactor>* early,
                                           const CondensationSettings& settings,
                                           FactorReport& report)
    : rows_(divide_rows_by_level(K, externals, blocks)) {
  CondensationSettings own = settings;
  own.solutions = 0.0; // the blocks on top have made the choice
  own.loads = nullptr; // their columns have the rows of K
  UnknownPlaces places;
  if (settings.places != nullptr) {
    places = lower_level_places(*settings.places, rows_);
    own.places = &places;
  }
  below_ = condense_equations(lower_level_matrix(K, rows_),
                              static_cast<std::int64_t>(rows_.touched.size()), own);
  report = below_->report();
  EarlyLateRowPartition lists;
  if (early != nullptr) {
    find_externals_of_block_alone(K, blocks, rows_);
  }
  if (!rows_.early.empty()) {
    lists = partition_block(rows_, blocks.front());
  }
  add_upper_level_cost(rows_, early != nullptr && *early && (*early)->partition() == lists, report);
  if (report.status != FactorStatus::ok) {
    // The matrix below has numbers of its own; messages want those of K.
    if (report.failed_row >= 0) {
      report.failed_row = rows_.below[at(report.failed_row)];
    }
    return;
  }
  const double started = thread_cpu_seconds();
  const base::Matrix touched = below_->take_schur();
  UpperLevelParts parts = assemble(K, blocks, touched);
  if (!rows_.early.empty() && !eliminate_early(blocks.front(), std::move(lists), *early, parts)) {
    // The block alone does not hold its early rows, the rest of the body may: S is formed after
    // all, from parts that are laid out otherwise.
    rows_.early.clear();
    parts = assemble(K, blocks, touched);
  }
  eliminate(std::move(parts), report);
  report.numeric_cpu += thread_cpu_seconds() - started;
}

TwoLevelCondensation::UpperLevelParts
TwoLevelCondensation::assemble(const base::SymmetricCsc& K,
                               std::span<const CondensedNetBlock> blocks,
                               const base::Matrix& touched) const {
  const Eigen::Index inner = rows_.inner_count();
  const bool layered = !rows_.early.empty();
  UpperLevelParts parts;
  Eigen::Index rest = 0;
  for (std::size_t t = 0; t < rows_.top.size(); ++t) {
    const auto k = index(t);
    // The inner rows are among the rest only where S is factorised: then they are late rows of one
    // matrix with the externals.
    const bool in = layered ? !std::ranges::binary_search(rows_.early, k) : k >= inner;
    parts.place.push_back(in ? rest++ : -1);
  }
  parts.inner = base::Matrix::Zero(inner, inner);
  parts.coupling = base::Matrix::Zero(inner, rows_.external);
  parts.rest = base::Matrix::Zero(rest, rest);
  // Adds a full symmetric matrix to the parts it falls into; `to_rest` is false for the block of
  // early rows, whose Schur complement takes its place among the rest.
  const auto add = [&](const std::vector<Eigen::Index>& top, const auto& part, bool to_rest) {
    for (std::size_t c = 0; c < top.size(); ++c) {
      const auto from = index(c);
      if (top[c] < 0) {
        continue;
      }
      auto first = top[c] < inner ? parts.inner.col(top[c]) : parts.coupling.col(top[c] - inner);
      const Eigen::Index column = to_rest ? parts.place[at(top[c])] : -1;
      for (std::size_t r = 0; r < top.size(); ++r) {
        if (top[r] < 0) {
          continue;
        }
        const double value = part(index(r), from);
        if (top[r] < inner) {
          first[top[r]] += value;
        }
        if (column >= 0 && parts.place[at(top[r])] >= 0) {
          parts.rest(parts.place[at(top[r])], column) += value;
        }
      }
    }
  };
  add(rows_.touched, touched, true);
  for (std::size_t i = 0; i < rows_.top.size(); ++i) {
    const auto k = index(i);
    if (!std::ranges::binary_search(rows_.touched, k)) {
      // K may have a diagonal entry, a spring, in rows that the sparse matrix does not touch.
      add({k}, base::Matrix::Constant(1, 1, K.value[at(K.start[at(rows_.top[i])])]), true);
    }
  }
  for (const CondensedNetBlock& b : blocks) {
    add(upper_level_positions(b, rows_.top), *b.stiffness, !layered);
  }
  return parts;
}

bool TwoLevelCondensation::eliminate_early(const CondensedNetBlock& dense,
                                           EarlyLateRowPartition lists,
                                           std::shared_ptr<const FirstBlockFactor>& early,
                                           UpperLevelParts& parts) {
  const std::vector<Eigen::Index> top = upper_level_positions(dense, rows_.top);
  std::vector<Eigen::Index> row(rows_.top.size(), -1); // by place on top: in the layered factor
  for (std::size_t k = 0; k < lists.early.size(); ++k) {
    row[at(top[at(lists.early[k])])] = index(k);
  }
  std::vector<Eigen::Index> place; // of the late ones among the rest
  for (const Eigen::Index r : lists.late) {
    place.push_back(parts.place[at(top[at(r)])]);
  }
  if (!early || early->partition() != lists) {
    early = std::make_shared<const FirstBlockFactor>(*dense.stiffness, std::move(lists));
  }
  if (!early->is_positive_definite()) {
    return false; // the block alone does not hold its rows
  }
  const base::Matrix& schur = early->schur();
  for (std::size_t c = 0; c < place.size(); ++c) {
    for (std::size_t r = 0; r < place.size(); ++r) {
      parts.rest(place[r], place[c]) += schur(index(r), index(c));
    }
  }
  const auto firsts = early->early_row_count();
  std::vector<Eigen::Index> externals;
  for (std::size_t t = at(rows_.inner_count()); t < row.size(); ++t) {
    // Rows of the layered factor: early ones first, then the rest.
    externals.push_back(row[t] >= 0 ? row[t] : firsts + parts.place[t]);
  }
  top_.factor.emplace(FactoredSchurComplement{
      TwoBlockCholesky(early, std::move(place), std::move(parts.rest)), std::move(externals)});
  return true;
}

bool TwoLevelCondensation::eliminate(UpperLevelParts parts, FactorReport& report) {
  const Eigen::Index inner = rows_.inner_count();
  const int i = static_cast<int>(inner);
  // Done also where S is in factored form: loads are condensed and locals recovered by this factor.
  L_ = parts.inner;
  const auto refuse = [&](Eigen::Index row) {
    report.status = FactorStatus::not_positive_definite;
    report.failed_row = rows_.top[at(row)];
    return false;
  };
  if (i > 0 && !blas::cholesky(i, blas::as_matrix_block(L_))) {
    report.smallest_pivot = 0.0;
    return refuse(first_bad_pivot(std::move(parts.inner)));
  }
  for (Eigen::Index k = 0; k < inner; ++k) {
    const double ratio = L_(k, k) * L_(k, k) / parts.inner(k, k);
    report.smallest_pivot = std::min(report.smallest_pivot, ratio);
    // (solve.7), by the entry that the row has after what lies below has been eliminated.
    if (!(ratio > smallest_allowed_pivot(static_cast<std::int64_t>(rows_.top.size())))) {
      return refuse(k);
    }
  }
  coupling_ = std::move(parts.coupling);
  if (!top_.factor) {
    base::Matrix X = coupling_;
    blas::solve_lower(i, static_cast<int>(rows_.external), blas::Transposition::plain,
                      blas::as_matrix_block(std::as_const(L_)), blas::as_matrix_block(X));
    top_.S = std::move(parts.rest) - gram_matrix(X);
  }
  return true;
}

void TwoLevelCondensation::solve_inner(base::Matrix& g, bool transposed) const {
  blas::solve_lower(static_cast<int>(rows_.inner_count()), static_cast<int>(g.cols()),
                    transposed ? blas::Transposition::transposed : blas::Transposition::plain,
                    blas::as_matrix_block(L_), blas::as_matrix_block(g));
}

// Loads of the sparse matrix: f of the rows below; what acts on top stays there.
base::Matrix TwoLevelCondensation::below(const base::Matrix& f) const {
  const auto locals = index(rows_.below.size());
  base::Matrix out = base::Matrix::Zero(locals + index(rows_.touched.size()), f.cols());
  for (Eigen::Index i = 0; i < locals; ++i) {
    out.row(i) = f.row(rows_.below[at(i)]);
  }
  return out;
}

// f on top with what the rows below hand over to those that they touch.
base::Matrix TwoLevelCondensation::on_top(const base::Matrix& f,
                                          const base::Matrix& condensed) const {
  base::Matrix g(index(rows_.top.size()), f.cols());
  for (Eigen::Index i = 0; i < g.rows(); ++i) {
    g.row(i) = f.row(rows_.top[at(i)]);
  }
  for (std::size_t t = 0; t < rows_.touched.size(); ++t) {
    g.row(rows_.touched[t]) += condensed.row(index(t));
  }
  return g;
}

base::Matrix TwoLevelCondensation::condense_top(base::Matrix g) const {
  // The inner rows of g become A_ii^-1 times them, A the full matrix on top.
  solve_inner(g, false);
  solve_inner(g, true);
  return g.bottomRows(rows_.external) - coupling_.transpose() * g.topRows(rows_.inner_count());
}

base::Matrix TwoLevelCondensation::condense_load(const base::Matrix& f) const {
  return condense_top(on_top(f, below_->condense_load(below(f))));
}

base::Matrix
TwoLevelCondensation::substitute(const base::Matrix& f,
                                 const ExternalDisplacementSolver& displacement) const {
  base::Matrix g;
  const base::Matrix inner = below_->solve(below(f), [&](const base::Matrix& condensed) {
    g = on_top(f, condensed);
    // Known displacements go to the right-hand side of the inner rows.
    if (rows_.external > 0) {
      const base::Matrix u_external = displacement(g);
      g.bottomRows(rows_.external) = u_external;
      g.topRows(rows_.inner_count()) -= coupling_ * u_external;
    }
    solve_inner(g, false);
    solve_inner(g, true);
    // The top is the only thing that the rows below see: its touched rows are their externals.
    base::Matrix u_touched(index(rows_.touched.size()), f.cols());
    for (std::size_t t = 0; t < rows_.touched.size(); ++t) {
      u_touched.row(index(t)) = g.row(rows_.touched[t]);
    }
    return u_touched;
  });
  base::Matrix u(f.rows(), f.cols());
  for (std::size_t i = 0; i < rows_.below.size(); ++i) {
    u.row(rows_.below[i]) = inner.row(index(i));
  }
  for (std::size_t i = 0; i < rows_.top.size(); ++i) {
    u.row(rows_.top[i]) = g.row(index(i));
  }
  return u;
}

base::Matrix TwoLevelCondensation::recover(const base::Matrix& u_external,
                                           const base::Matrix& f) const {
  return substitute(f, [&](const base::Matrix&) { return u_external; });
}

base::Matrix TwoLevelCondensation::solve(const base::Matrix& f,
                                         const ExternalDisplacementSolver& displacement) const {
  return substitute(f, [&](const base::Matrix& g) { return displacement(condense_top(g)); });
}

RowCompliance
TwoLevelCondensation::compliance_with_externals_held(const SparseRightHandSides& F) const {
  std::vector<std::int64_t> row(rows_.below.size() + rows_.top.size()); // below, then on top
  for (std::size_t i = 0; i < rows_.below.size(); ++i) {
    row[at(rows_.below[i])] = index(i);
  }
  const auto first_on_top = index(rows_.below.size());
  for (std::size_t t = 0; t < rows_.top.size(); ++t) {
    row[at(rows_.top[t])] = first_on_top + index(t);
  }
  SparseRightHandSides F_below;
  base::Matrix g = base::Matrix::Zero(index(rows_.top.size()), index(F.count()));
  for (std::int64_t k = 0; k < F.count(); ++k) {
    for (std::int64_t p = F.start[at(k)]; p < F.start[at(k + 1)]; ++p) {
      const std::int64_t place = row[at(F.row[at(p)])];
      if (place < first_on_top) {
        F_below.row.push_back(place);
        F_below.value.push_back(F.value[at(p)]);
      } else {
        g(place - first_on_top, k) += F.value[at(p)];
      }
    }
    F_below.start.push_back(index(F_below.row.size()));
  }
  RowCompliance out = below_->compliance_with_externals_held(std::move(F_below));
  for (std::size_t t = 0; t < rows_.touched.size(); ++t) {
    g.row(rows_.touched[t]) += out.condensed.row(index(t));
  }
  solve_inner(g, false);
  const auto inner = rows_.inner_count();
  out.W += gram_matrix(g.topRows(inner));
  out.flops += static_cast<double>(inner) * static_cast<double>(F.count()) *
               static_cast<double>(inner + F.count());
  solve_inner(g, true);
  out.condensed = g.bottomRows(rows_.external) - coupling_.transpose() * g.topRows(inner);
  return out;
}

} // namespace spricka::solve
