// SPDX-License-Identifier: GPL-3.0-or-later
#include "solve/swept_matrix.hpp"
#include "base/index.hpp"
#include "solve/blas.hpp"
#include "solve/set_solution.hpp"

#include <algorithm>
#include <optional>
#include <utility>

namespace spricka::solve {

using base::at;
using base::index;

SweptMatrix::SweptMatrix(const ControllableProblem& problem, base::Matrix of_force,
                         base::Matrix of_mode)
    : problem_(problem), n_(problem.rows()), m_(problem.mode_count()),
      of_force_(std::move(of_force)), of_mode_(std::move(of_mode)), factor_(problem) {}

// Forces are multiplied by d, gaps divided by it.
double SweptMatrix::unit(int i, bool closed) const {
  const double d = problem_.d(i) > 0.0 ? problem_.d(i) : 1.0;
  return closed ? d : 1.0 / d;
}

bool SweptMatrix::factorise_closed_rows(const std::vector<bool>& closed) {
  closed_ = closed;
  first_closed_ = closed;
  list_.clear(size());
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
  const SolutionWithRowsClosed s = solve_active_set(problem, factor_, true);
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

// T as factorised: a gap of a closed row, or a force on an open one, is answered by the forces of
// the closed rows and the modes, and these open the others.
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
  // Columns are those of the factorisation. Through the pivots since then they go all at once, or,
  // where rows have been exchanged twice or in pairs, one by one in column(): the age says how far
  // they are.
  const bool at_once = list_.can_apply_all_at_once() && !list_.empty();
  if (at_once) {
    list_.apply_all_pivots(all);
  }
  for (Eigen::Index c = 0; c < k; ++c) {
    made_[at(rows[at(c)])] = all.col(c);
    age_[at(rows[at(c)])] = at_once ? list_.size() : 0;
  }
}

base::Vector SweptMatrix::column(int i, std::span<const int> likely) {
  base::Vector x;
  std::size_t from = 0;
  // The last pivot that exchanged row i has its column in itself: no solution with the factor, and
  // none of the earlier pivots count.
  if (const std::optional<std::size_t> last = list_.find_last_pivot_of_row(i)) {
    x = list_.exchanged_row_column(*last, i);
    from = *last + 1;
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
    list_.apply_pivot(from, x);
  }
  return x;
}

void SweptMatrix::exchange(std::vector<int> rows, base::Matrix columns,
                           std::span<base::Vector* const> states) {
  for (const int i : rows) {
    closed_[at(i)] = !closed_[at(i)];
  }
  list_.append(std::move(rows), std::move(columns));
  for (base::Vector* state : states) {
    list_.apply_pivot(list_.size() - 1, *state);
  }
}

void SweptMatrix::pivot(int i, const base::Vector& column, std::span<base::Vector* const> states) {
  exchange({i}, column, states);
}

void SweptMatrix::pivot(std::array<int, 2> rows, std::array<base::Vector, 2> columns,
                        std::span<base::Vector* const> states) {
  base::Matrix both(size(), 2);
  both.col(0) = columns[0];
  both.col(1) = columns[1];
  exchange({rows[0], rows[1]}, std::move(both), states);
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

base::Vector SweptMatrix::mode_amplitudes(const base::Vector& state) const {
  return state.segment(n_, m_);
}

} // namespace spricka::solve
