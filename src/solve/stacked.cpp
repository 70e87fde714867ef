// SPDX-License-Identifier: GPL-3.0-or-later
#include "solve/stacked.hpp"
#include "solve/blas.hpp"
#include "solve/dense_cholesky.hpp"
#include "solve/factor_checks.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace spricka::solve {

namespace {

std::size_t at(std::int64_t i) {
  return static_cast<std::size_t>(i);
}

blas::Block block(base::Matrix& A) {
  return {A.data(), static_cast<int>(A.rows())};
}
blas::ConstBlock block(const base::Matrix& A) {
  return {A.data(), static_cast<int>(A.rows())};
}

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
  return A.rows() - 1;
}

} // namespace

bool stacking_pays(std::span<const DenseBlock> blocks, std::int64_t rows, std::int64_t externals) {
  std::vector<bool> on_top(at(rows), false);
  std::fill(on_top.end() - externals, on_top.end(), true);
  double filled = 0.0;
  for (const DenseBlock& b : blocks) {
    for (const std::int64_t row : b.rows) {
      if (row >= 0) {
        on_top[at(row)] = true;
      }
    }
    filled += static_cast<double>(b.rows.size()) * static_cast<double>(b.rows.size());
  }
  const auto size = static_cast<double>(std::ranges::count(on_top, true));
  return !blocks.empty() && 2.0 * filled > size * size;
}

Stacked::Rows Stacked::divide(const base::SymmetricCsc& K, std::int64_t externals,
                              std::span<const DenseBlock> blocks) {
  std::vector<bool> in_block(at(K.n), false);
  std::vector<bool> coupled(at(K.n), false);
  for (const DenseBlock& b : blocks) {
    for (const std::int64_t row : b.rows) {
      if (row >= 0) {
        in_block[at(row)] = true;
      }
    }
  }
  for (std::int64_t j = 0; j < K.n; ++j) {
    for (std::int64_t p = K.start[at(j)] + 1; p < K.start[at(j) + 1]; ++p) {
      coupled[at(j)] = true;
      coupled[at(K.row[at(p)])] = true;
    }
  }
  Rows rows;
  rows.external = externals;
  for (std::int64_t i = 0; i < K.n; ++i) {
    if (i < K.n - externals && !in_block[at(i)]) {
      rows.below.push_back(i);
      continue;
    }
    if (coupled[at(i)]) {
      rows.touched.push_back(static_cast<Eigen::Index>(rows.top.size()));
    }
    rows.top.push_back(i);
  }
  return rows;
}

// The rows below first, then the touched ones.
base::SymmetricCsc Stacked::sparse_part(const base::SymmetricCsc& K, const Rows& rows) {
  std::vector<std::int64_t> place(at(K.n), -1);
  std::int64_t next = 0;
  for (const std::int64_t row : rows.below) {
    place[at(row)] = next++;
  }
  for (const Eigen::Index t : rows.touched) {
    place[at(rows.top[at(t)])] = next++;
  }
  struct Entry {
    std::int64_t row;
    double value;
  };
  std::vector<std::vector<Entry>> column(at(next));
  for (std::int64_t j = 0; j < K.n; ++j) {
    for (std::int64_t p = K.start[at(j)]; p < K.start[at(j) + 1]; ++p) {
      const auto [c, r] = std::minmax(place[at(j)], place[at(K.row[at(p)])]);
      if (c >= 0) {
        column[at(c)].push_back({r, K.value[at(p)]});
      }
    }
  }
  base::SymmetricCsc A{next, {0}, {}, {}};
  for (std::vector<Entry>& entries : column) {
    std::ranges::sort(entries, {}, &Entry::row);
    for (const Entry& e : entries) {
      A.row.push_back(e.row);
      A.value.push_back(e.value);
    }
    A.start.push_back(static_cast<std::int64_t>(A.row.size()));
  }
  return A;
}

void Stacked::add_top(const Rows& rows, FactorReport& report) {
  const auto i = static_cast<double>(rows.inner());
  const auto e = static_cast<double>(rows.external);
  report.flops += i * i * i / 3.0 + i * i * e + i * e * e;
  report.factor_entries += 0.5 * i * i + i * e;
  report.kept_memory += 8.0 * (i * i + i * e);
  // the full matrix of the top, and the parts of it that are worked on
  report.memory += 8.0 * ((i + e) * (i + e) + i * i + i * e + e * e);
}

FactorReport Stacked::forecast(const base::SymmetricCsc& K, std::int64_t externals,
                               std::span<const DenseBlock> blocks) {
  const Rows rows = divide(K, externals, blocks);
  FactorReport report =
      Condensation::forecast(sparse_part(K, rows), static_cast<std::int64_t>(rows.touched.size()));
  add_top(rows, report);
  return report;
}

Stacked::Stacked(const base::SymmetricCsc& K, std::int64_t externals,
                 std::span<const DenseBlock> blocks, base::Matrix& S, FactorReport& report)
    : rows_(divide(K, externals, blocks)) {
  below_.emplace(sparse_part(K, rows_), static_cast<std::int64_t>(rows_.touched.size()));
  report = below_->report();
  add_top(rows_, report);
  if (report.status != FactorStatus::ok) {
    if (report.failed_row >= 0) {
      report.failed_row = rows_.below[at(report.failed_row)];
    }
    return;
  }
  const double started = thread_cpu();
  const auto size = static_cast<Eigen::Index>(rows_.top.size());
  base::Matrix D = base::Matrix::Zero(size, size);
  const auto add = [&D](const std::vector<Eigen::Index>& place, const base::Matrix& part) {
    for (std::size_t c = 0; c < place.size(); ++c) {
      for (std::size_t r = 0; r < place.size() && place[c] >= 0; ++r) {
        if (place[r] >= 0) {
          D(place[r], place[c]) += part(static_cast<Eigen::Index>(r), static_cast<Eigen::Index>(c));
        }
      }
    }
  };
  add(rows_.touched, below_->take_schur());
  for (std::size_t i = 0; i < rows_.top.size(); ++i) {
    if (!std::ranges::binary_search(rows_.touched, static_cast<Eigen::Index>(i))) {
      const auto k = static_cast<Eigen::Index>(i);
      D(k, k) += K.value[at(K.start[at(rows_.top[i])])];
    }
  }
  for (const DenseBlock& b : blocks) {
    std::vector<Eigen::Index> place;
    for (const std::int64_t row : b.rows) {
      place.push_back(row < 0 ? -1 : std::ranges::lower_bound(rows_.top, row) - rows_.top.begin());
    }
    add(place, *b.stiffness);
  }
  eliminate(D, S, report);
  report.numeric_cpu += thread_cpu() - started;
}

bool Stacked::eliminate(const base::Matrix& D, base::Matrix& S, FactorReport& report) {
  const Eigen::Index inner = rows_.inner();
  const int i = static_cast<int>(inner);
  const int e = static_cast<int>(rows_.external);
  L_ = D.topLeftCorner(inner, inner);
  const auto refuse = [&](Eigen::Index row) {
    report.status = FactorStatus::not_positive_definite;
    report.failed_row = rows_.top[at(row)];
    return false;
  };
  if (i > 0 && !blas::cholesky(i, block(L_))) {
    report.smallest_pivot = 0.0;
    return refuse(first_bad_pivot(D.topLeftCorner(inner, inner)));
  }
  for (Eigen::Index k = 0; k < inner; ++k) {
    const double ratio = L_(k, k) * L_(k, k) / D(k, k);
    report.smallest_pivot = std::min(report.smallest_pivot, ratio);
    if (!(ratio > smallest_allowed_pivot(static_cast<std::int64_t>(D.rows())))) {
      return refuse(k);
    }
  }
  X_ = D.topRightCorner(inner, rows_.external);
  blas::solve_lower(i, e, blas::Form::plain, block(std::as_const(L_)), block(X_));
  S = D.bottomRightCorner(rows_.external, rows_.external) - gram(X_);
  return true;
}

// Loads of the sparse matrix: f of the rows below; what acts on top stays there.
base::Matrix Stacked::below(const base::Matrix& f) const {
  const auto locals = static_cast<Eigen::Index>(rows_.below.size());
  base::Matrix out =
      base::Matrix::Zero(locals + static_cast<Eigen::Index>(rows_.touched.size()), f.cols());
  for (Eigen::Index i = 0; i < locals; ++i) {
    out.row(i) = f.row(rows_.below[at(i)]);
  }
  return out;
}

// f on top with what the rows below hand over; the inner part multiplied by L^-1.
base::Matrix Stacked::on_top(const base::Matrix& f, const base::Matrix& f_below) const {
  base::Matrix g(static_cast<Eigen::Index>(rows_.top.size()), f.cols());
  for (Eigen::Index i = 0; i < g.rows(); ++i) {
    g.row(i) = f.row(rows_.top[at(i)]);
  }
  const base::Matrix handed = below_->condense_load(f_below);
  for (std::size_t t = 0; t < rows_.touched.size(); ++t) {
    g.row(rows_.touched[t]) += handed.row(static_cast<Eigen::Index>(t));
  }
  blas::solve_lower(static_cast<int>(rows_.inner()), static_cast<int>(g.cols()), blas::Form::plain,
                    block(L_), block(g));
  return g;
}

base::Matrix Stacked::condense_load(const base::Matrix& f) const {
  const base::Matrix g = on_top(f, below(f));
  return g.bottomRows(rows_.external) - X_.transpose() * g.topRows(rows_.inner());
}

base::Matrix Stacked::recover(const base::Matrix& u_external, const base::Matrix& f) const {
  const base::Matrix f_below = below(f);
  base::Matrix g = on_top(f, f_below);
  if (rows_.external > 0) {
    g.bottomRows(rows_.external) = u_external;
    g.topRows(rows_.inner()) -= X_ * u_external;
  }
  blas::solve_lower(static_cast<int>(rows_.inner()), static_cast<int>(g.cols()),
                    blas::Form::transposed, block(L_), block(g));
  base::Matrix u_touched(static_cast<Eigen::Index>(rows_.touched.size()), f.cols());
  for (std::size_t t = 0; t < rows_.touched.size(); ++t) {
    u_touched.row(static_cast<Eigen::Index>(t)) = g.row(rows_.touched[t]);
  }
  const base::Matrix inner = below_->recover(u_touched, f_below);
  base::Matrix u(f.rows(), f.cols());
  for (std::size_t i = 0; i < rows_.below.size(); ++i) {
    u.row(rows_.below[i]) = inner.row(static_cast<Eigen::Index>(i));
  }
  for (std::size_t i = 0; i < rows_.top.size(); ++i) {
    u.row(rows_.top[i]) = g.row(static_cast<Eigen::Index>(i));
  }
  return u;
}

} // namespace spricka::solve
