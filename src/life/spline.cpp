// SPDX-License-Identifier: GPL-3.0-or-later
#include "life/spline.hpp"

#include "life/gsl.hpp"

#include <algorithm>
#include <cassert>
#include <cstddef>
#include <utility>

#include <gsl/gsl_linalg.h>

namespace spricka::life {

namespace {

double slope(const std::vector<double>& x, const std::vector<double>& y, std::size_t i) {
  return (y[i + 1] - y[i]) / (x[i + 1] - x[i]);
}

// Second derivatives at the points; those at the ends follow from one cubic over each outer pair of
// intervals and are eliminated.
std::vector<double> bends(const std::vector<double>& x, const std::vector<double>& y) {
  const std::size_t n = x.size();
  const std::size_t inner = n - 2;
  std::vector<double> diagonal(inner), above(inner - 1), below(inner - 1), right(inner), b(n);
  for (std::size_t i = 0; i < inner; ++i) {
    const double h0 = x[i + 1] - x[i];
    const double h1 = x[i + 2] - x[i + 1];
    diagonal[i] = 2.0 * (h0 + h1);
    right[i] = 6.0 * (slope(x, y, i + 1) - slope(x, y, i));
    if (i > 0) {
      below[i - 1] = h0;
    }
    if (i + 1 < inner) {
      above[i] = h1;
    }
  }
  const double first = (x[1] - x[0]) / (x[2] - x[1]);
  const double last = (x[n - 1] - x[n - 2]) / (x[n - 2] - x[n - 3]);
  // The second derivative at an end is b_1 + first (b_1 - b_2): its term in the outer equation goes
  // to those of b_1 and b_2.
  diagonal.front() += (x[1] - x[0]) * (1.0 + first);
  above.front() -= (x[1] - x[0]) * first;
  diagonal.back() += (x[n - 1] - x[n - 2]) * (1.0 + last);
  below.back() -= (x[n - 1] - x[n - 2]) * last;

  auto d = gsl_vector_view_array(diagonal.data(), inner);
  auto e = gsl_vector_view_array(above.data(), inner - 1);
  auto f = gsl_vector_view_array(below.data(), inner - 1);
  auto r = gsl_vector_view_array(right.data(), inner);
  auto solution = gsl_vector_view_array(&b[1], inner);
  quiet_gsl();
  gsl_linalg_solve_tridiag(&d.vector, &e.vector, &f.vector, &r.vector, &solution.vector);
  b.front() = b[1] + first * (b[1] - b[2]);
  b.back() = b[n - 2] + last * (b[n - 2] - b[n - 3]);
  return b;
}

} // namespace

CubicSpline::CubicSpline(std::vector<double> x, std::vector<double> y)
    : x_(std::move(x)), y_(std::move(y)), bend_(x_.size(), 0.0) {
  assert(x_.size() >= 2 && x_.size() == y_.size());
  if (x_.size() == 3) {
    bend_.assign(3, 2.0 * (slope(x_, y_, 1) - slope(x_, y_, 0)) / (x_[2] - x_[0]));
  } else if (x_.size() > 3) {
    bend_ = bends(x_, y_);
  }
}

double CubicSpline::operator()(double x) const {
  const auto above = std::upper_bound(x_.begin() + 1, x_.end() - 1, x);
  const auto i = static_cast<std::size_t>(above - x_.begin());
  const double h = x_[i] - x_[i - 1];
  const double t = (x - x_[i - 1]) / h;
  const double s = 1.0 - t;
  return s * y_[i - 1] + t * y_[i] -
         h * h / 6.0 * s * t * ((1.0 + s) * bend_[i - 1] + (1.0 + t) * bend_[i]);
}

} // namespace spricka::life
