// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/front_curve.hpp"

#include "shape/quadrature.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

#include <Eigen/Geometry>
#include <Eigen/SparseLU>

namespace spricka::mesh {

using base::Vec3;

namespace {

constexpr int arc_degree = 9; // of a piece's length: 1e-10 of it where it turns by a quarter

} // namespace

FrontCurve::FrontCurve(std::vector<Vec3> points, std::vector<Vec3> normals, bool closed)
    : x_(std::move(points)), normal_(std::move(normals)), closed_(closed) {
  assert(x_.size() == normal_.size() && x_.size() >= (closed ? 4U : 2U));
  const std::size_t count = closed_ ? x_.size() : x_.size() - 1;
  width_.reserve(count);
  for (std::size_t i = 0; i < count; ++i) {
    width_.push_back((x_[(i + 1) % x_.size()] - x_[i]).norm());
    assert(width_.back() > 0.0);
  }
  fit();
  arc_.assign(1, 0.0);
  for (std::size_t i = 0; i < count; ++i) {
    arc_.push_back(arc_.back() + arc_between(i, width_[i]));
  }
}

// Second derivatives M of the spline (de Boor 1978, IV): h0 M0 + 2 (h0 + h1) M1 + h1 M2 = 6 (slope
// after - slope before); at open ends the third derivative does not jump at the next knot.
void FrontCurve::fit() {
  const auto n = static_cast<Eigen::Index>(x_.size());
  bend_.assign(x_.size(), Vec3::Zero());
  if (n == 2) {
    return;
  }
  std::vector<Eigen::Triplet<double>> entries;
  base::Matrix right = base::Matrix::Zero(n, 3);
  const auto width = [&](Eigen::Index i) { return width_[static_cast<std::size_t>((i + n) % n)]; };
  const auto x = [&](Eigen::Index i) -> const Vec3& {
    return x_[static_cast<std::size_t>((i + n) % n)];
  };
  for (Eigen::Index i = closed_ ? 0 : 1; i < (closed_ ? n : n - 1); ++i) {
    const double before = width(i - 1);
    const double after = width(i);
    entries.emplace_back(i, (i - 1 + n) % n, before);
    entries.emplace_back(i, i, 2.0 * (before + after));
    entries.emplace_back(i, (i + 1) % n, after);
    right.row(i) = 6.0 * ((x(i + 1) - x(i)) / after - (x(i) - x(i - 1)) / before).transpose();
  }
  if (!closed_) {
    const auto end = [&](Eigen::Index row, Eigen::Index next, Eigen::Index third, double ratio) {
      entries.emplace_back(row, row, 1.0);
      entries.emplace_back(row, next, n == 3 ? -1.0 : -1.0 - ratio);
      if (n > 3) {
        entries.emplace_back(row, third, ratio);
      }
    };
    end(0, 1, 2, width(0) / width(1));
    end(n - 1, n - 2, n - 3, width(n - 2) / width(n - 3));
  }
  Eigen::SparseMatrix<double> A(n, n);
  A.setFromTriplets(entries.begin(), entries.end());
  Eigen::SparseLU<Eigen::SparseMatrix<double>> factor(A);
  assert(factor.info() == Eigen::Success);
  const base::Matrix bend = factor.solve(right);
  for (Eigen::Index i = 0; i < n; ++i) {
    bend_[static_cast<std::size_t>(i)] = bend.row(i);
  }
}

FrontCurve::SplineDerivatives FrontCurve::derivatives(SplinePosition at) const {
  const std::size_t next = (at.piece + 1) % x_.size();
  const double h = width_[at.piece];
  const double u = at.u;
  const double v = h - u;
  const Vec3& M0 = bend_[at.piece];
  const Vec3& M1 = bend_[next];
  const Vec3 low = x_[at.piece] / h - h / 6.0 * M0;
  const Vec3 high = x_[next] / h - h / 6.0 * M1;
  SplineDerivatives result;
  result.x = (v * v * v * M0 + u * u * u * M1) / (6.0 * h) + v * low + u * high;
  result.d1 = (u * u * M1 - v * v * M0) / (2.0 * h) - low + high;
  result.d2 = (v * M0 + u * M1) / h;
  return result;
}

double FrontCurve::arc_between(std::size_t piece, double u) const {
  double sum = 0.0;
  for (const auto& point : shape::line_rule(arc_degree)) {
    sum += point.weight * derivatives({piece, 0.5 * u * (1.0 + point.r[0])}).d1.norm();
  }
  return 0.5 * u * sum;
}

FrontCurve::SplinePosition FrontCurve::local(double s) const {
  const auto above = std::upper_bound(arc_.begin(), arc_.end(), s);
  const auto piece = static_cast<std::size_t>(std::clamp<std::ptrdiff_t>(
      above - arc_.begin() - 1, 0, static_cast<std::ptrdiff_t>(pieces()) - 1));
  const double wanted = s - arc_[piece];
  // Newton's steps: the speed is nearly 1 by the chord parameter.
  double u = wanted * width_[piece] / (arc_[piece + 1] - arc_[piece]);
  for (int i = 0; i < 8; ++i) {
    const double step = (wanted - arc_between(piece, u)) / derivatives({piece, u}).d1.norm();
    u += step;
    if (std::abs(step) < 1e-15 * width_[piece]) {
      break;
    }
  }
  return {piece, u};
}

FrontFrame FrontCurve::at(double s) const {
  FrontFrame frame;
  frame.s = s;
  double inside = s;
  if (closed_) {
    inside = s - length() * std::floor(s / length());
  } else {
    inside = std::clamp(s, 0.0, length());
  }
  const SplinePosition place = local(inside);
  const SplineDerivatives d = derivatives(place);
  const double speed = d.d1.norm();
  frame.t = d.d1 / speed;
  frame.dt = (d.d2 - frame.t.dot(d.d2) * frame.t) / (speed * speed);
  // b: between those of the knots, at right angles to t.
  const std::size_t next = (place.piece + 1) % x_.size();
  const double part = place.u / width_[place.piece];
  const Vec3 b0 = normal_[place.piece] + part * (normal_[next] - normal_[place.piece]);
  const Vec3 db0 = (normal_[next] - normal_[place.piece]) / (width_[place.piece] * speed);
  const Vec3 flat = b0 - frame.t.dot(b0) * frame.t;
  const Vec3 dflat =
      db0 - (frame.dt.dot(b0) + frame.t.dot(db0)) * frame.t - frame.t.dot(b0) * frame.dt;
  frame.b = flat.normalized();
  frame.db = (dflat - frame.b.dot(dflat) * frame.b) / flat.norm();
  frame.m = frame.b.cross(frame.t);
  frame.dm = frame.db.cross(frame.t) + frame.b.cross(frame.dt);
  frame.x = d.x;
  if (inside != s && !closed_) { // straight on beyond an end
    frame.x += (s - inside) * frame.t;
    frame.dt.setZero();
    frame.dm.setZero();
    frame.db.setZero();
  }
  return frame;
}

double FrontCurve::nearest_on(std::size_t piece, const Vec3& x) const {
  const double h = width_[piece];
  const std::size_t next = (piece + 1) % x_.size();
  double u = std::clamp((x - x_[piece]).dot(x_[next] - x_[piece]) / h, 0.0, h);
  for (int i = 0; i < 12; ++i) {
    const SplineDerivatives d = derivatives({piece, u});
    const double slope = (d.x - x).dot(d.d1);
    // Beyond the centre of curvature the second derivative changes its sign: Gauss' step then.
    const double full = d.d1.squaredNorm() + (d.x - x).dot(d.d2);
    const double step = -slope / (full > 0.1 * d.d1.squaredNorm() ? full : d.d1.squaredNorm());
    const double moved = std::clamp(u + step, 0.0, h);
    const bool still = std::abs(moved - u) < 1e-14 * h;
    u = moved;
    if (still) {
      break;
    }
  }
  return u;
}

double FrontCurve::nearest_length(const Vec3& x) const {
  // Pieces by their chords; those that may be nearest are asked exactly.
  std::vector<double> away(pieces());
  double least = std::numeric_limits<double>::max();
  for (std::size_t i = 0; i < pieces(); ++i) {
    const Vec3& a = x_[i];
    const Vec3 chord = x_[(i + 1) % x_.size()] - a;
    const double part = std::clamp((x - a).dot(chord) / chord.squaredNorm(), 0.0, 1.0);
    away[i] = (a + part * chord - x).norm();
    least = std::min(least, away[i]);
  }
  double best = std::numeric_limits<double>::max();
  SplinePosition place;
  for (std::size_t i = 0; i < pieces(); ++i) {
    // A piece bulges by a part of its chord.
    if (away[i] > least + 0.3 * width_[i]) {
      continue;
    }
    const double u = nearest_on(i, x);
    const double distance = (derivatives({i, u}).x - x).norm();
    if (distance < best) {
      best = distance;
      place = {i, u};
    }
  }
  const double s = arc_[place.piece] + arc_between(place.piece, place.u);
  if (closed_) {
    return s >= length() ? s - length() : s;
  }
  const FrontFrame end = at(s);
  if ((place.piece == 0 && place.u == 0.0) ||
      (place.piece + 1 == pieces() && place.u == width_.back())) {
    return s + (x - end.x).dot(end.t);
  }
  return s;
}

} // namespace spricka::mesh
