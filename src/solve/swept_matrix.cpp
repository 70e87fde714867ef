// SPDX-License-Identifier: GPL-3.0-or-later
#include "solve/swept_matrix.hpp"
#include "base/index.hpp"
#include "solve/blas.hpp"
#include "solve/set_solution.hpp"

#include <algorithm>
#include <utility>

#include <Eigen/LU>

namespace spricka::solve {

using base::at;
using base::index;

SweptMatrix::SweptMatrix(const ControllableProblem& problem, base::Matrix of_force,
                         base::Matrix of_mode)
    : problem_(problem), n_(problem.rows()), m_(problem.modes()), of_force_(std::move(of_force)),
      of_mode_(std::move(of_mode)), factor_(problem) {}

// Forces are multiplied by d, gaps divided by it.
double SweptMatrix::unit(int i, bool closed) const {
  const double d = problem_.d(i) > 0.0 ? problem_.d(i) : 1.0;
  return closed ? d : 1.0 / d;
}

bool SweptMatrix::begin(const std::vector<bool>& closed) {
  closed_ = closed;
  first_closed_ = closed;
  list_.clear();
  block_ = {.sound = true, .rows = {}, .columns = base::Matrix(size(), 0), .core = {}};
  made_.assign(static_cast<std::size_t>(n_), base::Vector());
  age_.assign(static_cast<std::size_t>(n_), 0);
  std::vector<int> A;
  open_.clear();
  for (int i = 0; i < n_; ++i) {
    (closed[at(i)] ? A : open_).push_back(i);
  }
  // Copied out once, so that gaps of many columns are one product of full matrices.
  W_open_.resize(index(open_.size()), n_);
  for (Eigen::Index k = 0; k < W_open_.rows(); ++k) {
    W_open_.row(k) = problem_.W.col(open_[at(k)]); // symmetric
  }
  return factor_.factorise(std::move(A)) && factor_.redundant_rows().empty();
}

base::Vector SweptMatrix::initial_state(const base::Vector& b, const base::Vector& h) const {
  ControllableProblem problem = problem_;
  problem.b = b;
  problem.h = h;
  const ActiveSetSolution s = solve_active_set(problem, factor_, true);
  base::Vector c(size());
  for (int i = 0; i < n_; ++i) {
    const bool closed = first_closed_[at(i)];
    c(i) = (closed ? s.lambda(i) : s.gap(i)) * unit(i, closed);
  }
  // Modes and functionals keep their own units: nothing is exchanged in them.
  c.segment(n_, m_) = s.alpha;
  c.tail(of_force_.rows()) = of_force_ * s.lambda + of_mode_ * s.alpha;
  return c;
}

void SweptMatrix::add_to_block(const PivotExchange& pivot) {
  const int i = pivot.rows[0];
  block_.sound = block_.sound && pivot.rows.size() == 1 &&
                 std::find(block_.rows.begin(), block_.rows.end(), i) == block_.rows.end();
  if (!block_.sound) {
    return;
  }
  const auto l = index(block_.rows.size());
  if (l == block_.columns.cols()) {
    // Room doubles, so that columns are copied seldom.
    const Eigen::Index more = 2 * l + 64;
    block_.columns.conservativeResize(Eigen::NoChange, more);
    block_.core.conservativeResize(more, more);
  }
  // From here on row i holds -s of this pivot. What earlier columns have in it is used once, to
  // find this s, and is then cleared: advance() must not subtract it again.
  block_.core.row(l).head(l) = block_.columns.row(i).head(l);
  block_.core(l, l) = pivot.columns(i, 0);
  block_.columns.row(i).head(l).setZero();
  block_.columns.col(l) = pivot.columns.col(0);
  block_.columns(i, l) = 0.0;
  block_.rows.push_back(i);
}

void SweptMatrix::advance(base::Matrix& columns) const {
  const auto l = index(block_.rows.size());
  base::Matrix s(l, columns.cols());
  for (Eigen::Index j = 0; j < l; ++j) {
    // A row is exchanged once only while the block is sound, so the order of taking does not
    // matter.
    s.row(j) = columns.row(block_.rows[at(j)]);
    columns.row(block_.rows[at(j)]).setZero();
  }
  block_.core.topLeftCorner(l, l).triangularView<Eigen::Lower>().solveInPlace(s);
  base::Matrix change(columns.rows(), columns.cols());
  const auto length = static_cast<int>(columns.rows());
  const auto count = static_cast<int>(l);
  blas::gemm({.m = length, .n = static_cast<int>(columns.cols()), .k = count},
             {block_.columns.data(), length}, {s.data(), count}, {change.data(), length});
  columns -= change;
  for (Eigen::Index j = 0; j < l; ++j) {
    columns.row(block_.rows[at(j)]) -= s.row(j);
  }
}

// T at begin: a gap of a closed row, or a force on an open one, is answered by the forces of the
// closed rows and the modes, and these open the others.
void SweptMatrix::make_columns(const std::vector<int>& rows) {
  const std::vector<int>& A = factor_.rows();
  const auto a = index(A.size());
  const auto k = index(rows.size());
  base::Matrix top = base::Matrix::Zero(a, k);
  base::Matrix bottom = base::Matrix::Zero(m_, k);
  for (Eigen::Index c = 0; c < k; ++c) {
    const int i = rows[at(c)];
    if (first_closed_[at(i)]) {
      top(std::lower_bound(A.begin(), A.end(), i) - A.begin(), c) = 1.0;
      continue;
    }
    for (Eigen::Index r = 0; r < a; ++r) {
      top(r, c) = -problem_.W(A[at(r)], i);
    }
    bottom.col(c) = -problem_.B.row(i).transpose();
  }
  factor_.solve(top, bottom);
  base::Matrix force = base::Matrix::Zero(n_, k);
  for (Eigen::Index c = 0; c < k; ++c) {
    for (Eigen::Index r = 0; r < a; ++r) {
      force(A[at(r)], c) = top(r, c);
    }
    if (!first_closed_[at(rows[at(c)])]) {
      force(rows[at(c)], c) = 1.0;
    }
  }
  const int open = static_cast<int>(open_.size());
  const int columns = static_cast<int>(k);
  const int n = static_cast<int>(n_);
  base::Matrix gap(open, k);
  blas::gemm({.m = open, .n = columns, .k = n}, {W_open_.data(), open}, {force.data(), n},
             {gap.data(), open});
  for (Eigen::Index r = 0; r < open; ++r) {
    gap.row(r) += problem_.B.row(open_[at(r)]) * bottom;
  }
  const base::Matrix more = of_force_ * force + of_mode_ * bottom;
  base::Matrix all(size(), k);
  for (Eigen::Index c = 0; c < k; ++c) {
    const int i = rows[at(c)];
    const double own = unit(i, first_closed_[at(i)]);
    auto column = all.col(c);
    for (Eigen::Index r = 0; r < a; ++r) {
      column(A[at(r)]) = top(r, c) * own * unit(A[at(r)], true);
    }
    for (Eigen::Index r = 0; r < open; ++r) {
      column(open_[at(r)]) = gap(r, c) * own * unit(open_[at(r)], false);
    }
    column.segment(n_, m_) = bottom.col(c) * own;
    column.tail(more.rows()) = more.col(c) * own;
  }
  // Columns are those at begin. Through the pivots since then they go all at once, or, where rows
  // have been exchanged twice or in pairs, one by one in column(): the age says how far they are.
  const bool at_once = block_.sound && !list_.empty();
  if (at_once) {
    advance(all);
  }
  for (Eigen::Index c = 0; c < k; ++c) {
    made_[at(rows[at(c)])] = all.col(c);
    age_[at(rows[at(c)])] = at_once ? list_.size() : 0;
  }
}

base::Vector SweptMatrix::column(int i, std::span<const int> likely) {
  // The last pivot that exchanged row i has its column in itself: no solution with the factor, and
  // none of the earlier pivots count.
  std::size_t from = list_.size();
  while (from > 0) {
    const PivotExchange& p = list_[from - 1];
    if (std::find(p.rows.begin(), p.rows.end(), i) != p.rows.end()) {
      break;
    }
    --from;
  }
  base::Vector x;
  if (from > 0) {
    // `from` is one behind that pivot already: the loop below goes on with those after it.
    x = own_column(list_[from - 1], i);
  } else {
    if (made_[at(i)].size() == 0) {
      std::vector<int> rows{i};
      for (const int j : likely) {
        if (j != i && made_[at(j)].size() == 0) {
          rows.push_back(j);
        }
      }
      make_columns(rows);
    }
    x = made_[at(i)];
    from = age_[at(i)];
  }
  for (; from < list_.size(); ++from) {
    apply(list_[from], x);
  }
  return x;
}

// (solve.30) for one column or state, P the exchanged rows: in the place of x_P comes what
// z_P has to be, -inverse x_P, and the rest follows along the columns of the pivot.
void SweptMatrix::apply(const PivotExchange& pivot, base::Vector& x) {
  if (pivot.rows.size() == 1) {
    const double z = x(pivot.rows[0]) * pivot.inverse(0, 0);
    if (z != 0.0) {
      x.noalias() -= z * pivot.columns.col(0);
    }
    x(pivot.rows[0]) = -z;
    return;
  }
  const Eigen::Vector2d z = pivot.inverse * Eigen::Vector2d(x(pivot.rows[0]), x(pivot.rows[1]));
  x.noalias() -= pivot.columns * z;
  x(pivot.rows[0]) = -z(0);
  x(pivot.rows[1]) = -z(1);
}

// The column of a row that this pivot exchanges, right after it: columns times inverse, the inverse
// itself in the exchanged rows.
base::Vector SweptMatrix::own_column(const PivotExchange& pivot, int i) {
  const Eigen::Index k = pivot.rows[0] == i ? 0 : 1;
  base::Vector x = pivot.columns * pivot.inverse.col(k);
  for (std::size_t r = 0; r < pivot.rows.size(); ++r) {
    x(pivot.rows[r]) = pivot.inverse(index(r), k);
  }
  return x;
}

void SweptMatrix::exchange(PivotExchange pivot, std::span<base::Vector* const> states) {
  const auto p = index(pivot.rows.size());
  base::Matrix core(p, p);
  for (Eigen::Index r = 0; r < p; ++r) {
    core.row(r) = pivot.columns.row(pivot.rows[at(r)]);
  }
  pivot.inverse = core.inverse();
  for (base::Vector* state : states) {
    apply(pivot, *state);
  }
  for (const int i : pivot.rows) {
    closed_[at(i)] = !closed_[at(i)];
  }
  add_to_block(pivot);
  list_.push_back(std::move(pivot));
}

void SweptMatrix::pivot(int i, const base::Vector& column, std::span<base::Vector* const> states) {
  exchange({{i}, column, {}}, states);
}

void SweptMatrix::pivot(std::array<int, 2> rows, std::array<base::Vector, 2> columns,
                        std::span<base::Vector* const> states) {
  base::Matrix both(size(), 2);
  both.col(0) = columns[0];
  both.col(1) = columns[1];
  exchange({{rows[0], rows[1]}, std::move(both), {}}, states);
}

base::Vector SweptMatrix::forces(const base::Vector& state) const {
  base::Vector lambda = base::Vector::Zero(n_);
  for (int i = 0; i < n_; ++i) {
    if (closed_[at(i)]) {
      lambda(i) = state(i) / unit(i, true);
    }
  }
  return lambda;
}

base::Vector SweptMatrix::open_gaps(const base::Vector& state) const {
  base::Vector gap = base::Vector::Zero(n_);
  for (int i = 0; i < n_; ++i) {
    if (!closed_[at(i)]) {
      gap(i) = state(i) / unit(i, false);
    }
  }
  return gap;
}

base::Vector SweptMatrix::modes(const base::Vector& state) const {
  return state.segment(n_, m_);
}

} // namespace spricka::solve
