// SPDX-License-Identifier: GPL-3.0-or-later
#include "life/smoothing.hpp"

#include "life/gsl.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <limits>
#include <memory>

#include <Eigen/Dense>
#include <gsl/gsl_bspline.h>
#include <gsl/gsl_cdf.h>

namespace spricka::life {

namespace {

constexpr std::size_t k_most_intervals = 50;
// The factor of Kim and Gu in (life.19).
constexpr double k_freedom_cost = 1.4;

// Cubic B-splines over [0, 1] between ascending breaks.
class Basis {
public:
  explicit Basis(const std::vector<double>& breaks)
      : work_(gsl_bspline_alloc(4, breaks.size())), values_(gsl_matrix_alloc(4, 3)) {
    const auto view = gsl_vector_const_view_array(breaks.data(), breaks.size());
    gsl_bspline_knots(&view.vector, work_.get());
  }
  [[nodiscard]] Eigen::Index size() const {
    return static_cast<Eigen::Index>(gsl_bspline_ncoeffs(work_.get()));
  }
  // The derivative of that order of all functions at x, as a row.
  [[nodiscard]] Eigen::RowVectorXd row(double x, std::size_t order) const {
    Eigen::RowVectorXd all = Eigen::RowVectorXd::Zero(size());
    std::size_t first = 0;
    std::size_t last = 0;
    gsl_bspline_deriv_eval_nonzero(x, 2, values_.get(), &first, &last, work_.get());
    for (std::size_t i = first; i <= last; ++i) {
      all[static_cast<Eigen::Index>(i)] = gsl_matrix_get(values_.get(), i - first, order);
    }
    return all;
  }

private:
  std::unique_ptr<gsl_bspline_workspace, GslDeleter<gsl_bspline_free>> work_;
  std::unique_ptr<gsl_matrix, GslDeleter<gsl_matrix_free>> values_;
};

// From 0 to 1, at points of x (scaled to that), as many points in every interval but for one.
std::vector<double> breaks_at(const std::vector<double>& x) {
  const std::size_t n = x.size();
  const std::size_t intervals = std::min(k_most_intervals, n / 2 - 2);
  std::vector<double> breaks;
  for (std::size_t i = 0; i <= intervals; ++i) {
    breaks.push_back(x[i * (n - 1) / intervals]);
  }
  return breaks;
}

// Integral of f''^2 as a form of the coefficients: f'' is linear in each interval, two points do.
Eigen::MatrixXd bending(const Basis& basis, const std::vector<double>& breaks) {
  Eigen::MatrixXd form = Eigen::MatrixXd::Zero(basis.size(), basis.size());
  for (std::size_t i = 1; i < breaks.size(); ++i) {
    const double half = 0.5 * (breaks[i] - breaks[i - 1]);
    for (const double s : {-1.0 / std::sqrt(3.0), 1.0 / std::sqrt(3.0)}) {
      const Eigen::RowVectorXd row = basis.row(breaks[i - 1] + half * (1.0 + s), 2);
      form += half * row.transpose() * row;
    }
  }
  return form;
}

struct SmoothingFit {
  Eigen::LDLT<Eigen::MatrixXd> factor;
  Eigen::VectorXd coefficients;
  double square = 0.0; ///< of the weighted residuals, their sum
  double freedoms = 0.0;
  double criterion = std::numeric_limits<double>::infinity();
};

SmoothingFit fit_with(double lambda, const Eigen::MatrixXd& X, const Eigen::VectorXd& y,
                      const Eigen::MatrixXd& form) {
  const Eigen::MatrixXd normal = X.transpose() * X;
  SmoothingFit fit;
  fit.factor.compute(normal + lambda * form);
  fit.coefficients = fit.factor.solve(X.transpose() * y);
  fit.square = (y - X * fit.coefficients).squaredNorm();
  fit.freedoms = fit.factor.solve(normal).trace();
  const auto n = static_cast<double>(y.size());
  // Where it is not above 0 the criterion says nothing: it stays infinite.
  const double left = 1.0 - k_freedom_cost * fit.freedoms / n;
  if (left > 0.0) {
    fit.criterion = fit.square / (n * left * left);
  }
  return fit;
}

// Of penalties from hardly any to a straight line, two to each factor of ten.
SmoothingFit best_fit(const Eigen::MatrixXd& X, const Eigen::VectorXd& y,
                      const Eigen::MatrixXd& form) {
  // Makes the two terms comparable, so that the same powers of ten serve for any test.
  const double scale = X.squaredNorm() / form.trace();
  SmoothingFit best;
  for (int i = -24; i <= 12; ++i) {
    SmoothingFit fit = fit_with(scale * std::pow(10.0, 0.5 * i), X, y, form);
    if (fit.criterion < best.criterion || best.coefficients.size() == 0) {
      best = std::move(fit);
    }
  }
  return best;
}

} // namespace

SmoothedCurve fit_smoothing_spline(const std::vector<double>& x, const std::vector<double>& y,
                                   const std::vector<double>& weight) {
  assert(x.size() >= 8 && y.size() == x.size() && weight.size() == x.size());
  disable_gsl_error_handler();
  const double length = x.back() - x.front();
  std::vector<double> s;
  s.reserve(x.size());
  for (const double each : x) {
    s.push_back((each - x.front()) / length);
  }
  const std::vector<double> breaks = breaks_at(s);
  const Basis basis(breaks);
  const auto n = static_cast<Eigen::Index>(x.size());
  Eigen::MatrixXd X(n, basis.size());
  Eigen::VectorXd right(n);
  for (Eigen::Index i = 0; i < n; ++i) {
    const auto k = static_cast<std::size_t>(i);
    X.row(i) = weight[k] * basis.row(s[k], 0);
    right[i] = weight[k] * y[k];
  }
  const SmoothingFit fit = best_fit(X, right, bending(basis, breaks));
  SmoothedCurve curve;
  curve.freedoms = fit.freedoms;
  curve.deviation = std::sqrt(fit.square / (static_cast<double>(n) - fit.freedoms));
  for (std::size_t i = 0; i < x.size(); ++i) {
    const Eigen::RowVectorXd slope = basis.row(s[i], 1);
    curve.value.push_back(basis.row(s[i], 0).dot(fit.coefficients));
    curve.slope.push_back(slope.dot(fit.coefficients) / length);
    // (life.20) without e^f and the quantile; by x itself, which has been scaled by the length.
    const double variance = slope.dot(fit.factor.solve(slope.transpose()).transpose());
    curve.slope_error.push_back(curve.deviation * std::sqrt(std::max(variance, 0.0)) / length);
  }
  return curve;
}

double two_sided_student_quantile_95(double freedoms) {
  return gsl_cdf_tdist_Pinv(0.975, freedoms);
}

} // namespace spricka::life
