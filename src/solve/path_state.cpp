// SPDX-License-Identifier: GPL-3.0-or-later
#include "solve/path_state.hpp"

#include "solve/path_parts.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace spricka::solve {

using base::at;

namespace {

constexpr std::size_t together = 128; ///< columns made at once

} // namespace

bool PathState::factorise(const std::vector<bool>& closed) {
  if (!matrix_.factorise_closed_rows(closed)) {
    return false;
  }
  v_ = matrix_.initial_state(held_.b, held_.h);
  d_ = matrix_.initial_state(problem_.db, dh_);
  v_.tail(problem_.f0.size()) += problem_.f0;
  d_.tail(problem_.df.size()) += problem_.df;
  // Round-off is measured by the largest force anywhere on the path, not by those at this t: all
  // may vanish here.
  double size = 0.0;
  for (int i = 0; i < rows(); ++i) {
    if (closed[at(i)]) {
      size = std::max(size, std::abs(force_or_gap(i)) + (to_ - from_) * std::abs(d_(i)));
    }
  }
  size_ = size;
  tolerance_.resize(rows());
  for (int i = 0; i < rows(); ++i) {
    // The same for gaps: the given ones at both ends of the path.
    const double gap = std::max(std::abs(held_.b(i) + from_ * problem_.db(i)),
                                std::abs(held_.b(i) + to_ * problem_.db(i)));
    level_(i) = held_.d(i) > 0.0 ? gap / held_.d(i) : gap;
    tolerance_(i) = relative_tolerance_ * (size + level_(i));
  }
  return true;
}

int PathState::count_falling_rows_at_zero() const {
  int count = 0;
  for (int i = 0; i < rows(); ++i) {
    count += is_inequality_row(i) && is_at_zero(i) && falls(i) ? 1 : 0;
  }
  return count;
}

// The least index, not the worst row: exchanges then come to an end where several tie (Murty 1974).
int PathState::first_falling_row_at_zero() const {
  for (int i = 0; i < rows(); ++i) {
    if (is_inequality_row(i) && is_at_zero(i) && falls(i)) {
      return i;
    }
  }
  return -1;
}

double PathState::parameter_of_next_event() const {
  double t = to_;
  for (int i = 0; i < rows(); ++i) {
    if (is_inequality_row(i) && falls(i)) {
      t = std::min(t, time_of(i));
    }
  }
  return t;
}

// The rows that reach zero first, soonest first: columns solved for together cost little more than
// one alone.
std::vector<int> PathState::likely() const {
  std::vector<std::pair<double, int>> order;
  for (int i = 0; i < rows(); ++i) {
    if (is_inequality_row(i) && falls(i) && time_of(i) <= to_) {
      order.emplace_back(time_of(i), i);
    }
  }
  const auto count = std::min(together, order.size());
  std::partial_sort(order.begin(), order.begin() + static_cast<std::ptrdiff_t>(count), order.end());
  std::vector<int> out;
  for (std::size_t k = 0; k < count; ++k) {
    out.push_back(order[k].second);
  }
  return out;
}

base::Vector PathState::column(int i) {
  // Others are made along only where a solution with the factor is due anyway.
  return matrix_.column(i, matrix_.has_column(i) ? std::vector<int>() : likely());
}

int PathState::first_blocking_row(const base::Vector& x, int i) const {
  // Of rows that fall as z_i grows the one with the smallest ratio: none goes below zero.
  double least = std::numeric_limits<double>::infinity();
  int found = -1;
  for (int j = 0; j < rows(); ++j) {
    if (j != i && is_inequality_row(j) && x(j) < -no_pivot) {
      const double z = std::max(force_or_gap(j), 0.0) / -x(j);
      if (z < least) {
        least = z;
        found = j;
      }
    }
  }
  return found;
}

void PathState::pivot(int i, const base::Vector& x) {
  matrix_.pivot(i, x, std::array<base::Vector*, 2>{&v_, &d_});
}

void PathState::pivot(std::array<int, 2> rows, std::array<base::Vector, 2> columns) {
  matrix_.pivot(rows, std::move(columns), std::array<base::Vector*, 2>{&v_, &d_});
}

// A thousand tolerances: the rows were found a little further on, not here, and what is off by less
// is zero to the walk, and exchanged where it falls.
bool PathState::is_valid_with_same_functionals(const base::Vector& f) const {
  for (int i = 0; i < rows(); ++i) {
    if (is_inequality_row(i) && force_or_gap(i) < -1e3 * tolerance_(i)) {
      return false;
    }
  }
  const base::Vector now = state().tail(f.size());
  const double size =
      (now.cwiseAbs() + (to_ - from_) * d_.tail(f.size()).cwiseAbs() + f.cwiseAbs()).sum();
  return f.size() == 0 || (now - f).cwiseAbs().maxCoeff() <= 1e-8 * size;
}

double PathState::residual() const {
  ControllableProblem here = held_;
  here.b += t_ * problem_.db;
  here.h += t_ * dh_;
  // Loads at both ends of the path: their sum may vanish at this t.
  const base::Vector ends = (held_.h + from_ * dh_).cwiseAbs() + (held_.h + to_ * dh_).cwiseAbs();
  return path_residual(here, matrix_, state(), {size_, level_, ends});
}

} // namespace spricka::solve
