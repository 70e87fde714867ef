// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/clock.hpp"
#include "solve/contact_qp.hpp"

#include <Eigen/QR>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <gtest/gtest.h>
#include <numbers>
#include <optional>
#include <random>
#include <vector>

namespace spricka::solve {
namespace {

using base::Matrix;
using base::Vector;

std::size_t at(Eigen::Index i) {
  return static_cast<std::size_t>(i);
}

ContactProblem problem_of(const Matrix& W, const Vector& b) {
  ContactProblem p;
  p.W = W;
  p.b = b;
  p.B = Matrix(b.size(), 0);
  p.h = Vector(0);
  p.equality.assign(at(b.size()), false);
  return p;
}

ContactSolution solve(const ContactProblem& p, const std::vector<bool>& start = {}) {
  return solve_contact(p, ContactSettings{}, start);
}

/// Largest violation of the conditions, over the size of the terms (gaps at least: `length`).
double violation(const ContactProblem& p, const ContactSolution& s, double length = 1.0) {
  const Vector opened = p.W * s.lambda;
  const Vector moved = p.B * s.alpha;
  const Vector g = p.b + opened + moved;
  const double size = length + p.b.cwiseAbs().maxCoeff() + opened.cwiseAbs().maxCoeff() +
                      (moved.size() > 0 ? moved.cwiseAbs().maxCoeff() : 0.0);
  const double force = 1e-300 + s.lambda.cwiseAbs().maxCoeff();
  double worst = 0.0;
  for (Eigen::Index i = 0; i < g.size(); ++i) {
    if (p.equality[at(i)]) {
      worst = std::max(worst, std::abs(g(i)) / size);
      continue;
    }
    worst = std::max({worst, -g(i) / size, -s.lambda(i) / force,
                      std::min(std::abs(g(i)) / size, s.lambda(i) / force),
                      std::abs(std::max(g(i), 0.0) - s.gap(i)) / size});
  }
  const Vector balance = p.h + p.B.transpose() * s.lambda;
  const Vector terms = p.h.cwiseAbs() + p.B.cwiseAbs().transpose() * s.lambda.cwiseAbs();
  for (Eigen::Index j = 0; j < balance.size(); ++j) {
    worst = std::max(worst, std::abs(balance(j)) / (1e-300 + terms(j)));
  }
  return worst;
}

/// The answer by trying every set of closed rows; nothing when no set satisfies the conditions.
std::optional<ContactSolution> enumerate(const ContactProblem& p) {
  const Eigen::Index n = p.b.size();
  const Eigen::Index m = p.h.size();
  for (unsigned set = 0; set < (1U << n); ++set) {
    std::vector<Eigen::Index> A;
    bool possible = true;
    for (Eigen::Index i = 0; i < n; ++i) {
      const bool closed = (set >> i & 1U) != 0;
      possible = possible && (closed || !p.equality[at(i)]);
      if (closed) {
        A.push_back(i);
      }
    }
    if (!possible) {
      continue;
    }
    const Eigen::Index a = static_cast<Eigen::Index>(A.size());
    Matrix K = Matrix::Zero(a + m, a + m);
    Vector r(a + m);
    for (Eigen::Index i = 0; i < a; ++i) {
      for (Eigen::Index j = 0; j < a; ++j) {
        K(i, j) = p.W(A[at(i)], A[at(j)]);
      }
      K.block(i, a, 1, m) = p.B.row(A[at(i)]);
      K.block(a, i, m, 1) = p.B.row(A[at(i)]).transpose();
      r(i) = -p.b(A[at(i)]);
    }
    r.tail(m) = -p.h;
    ContactSolution s;
    s.lambda = Vector::Zero(n);
    s.alpha = Vector::Zero(m);
    if (a + m > 0) {
      Eigen::CompleteOrthogonalDecomposition<Matrix> qr(K.rows(), K.cols());
      qr.setThreshold(1e-11);
      const Vector x = qr.compute(K).solve(r);
      if (!((K * x - r).norm() <= 1e-9 * (r.norm() + 1e-300))) {
        continue;
      }
      for (Eigen::Index i = 0; i < a; ++i) {
        s.lambda(A[at(i)]) = x(i);
      }
      s.alpha = x.tail(m);
    }
    s.gap = (p.b + p.W * s.lambda + p.B * s.alpha).cwiseMax(0.0);
    if (violation(p, s) < 1e-9) {
      return s;
    }
  }
  return std::nullopt;
}

/// Random bodies: N elastic freedoms, m rigid modes, n constraint rows with twins, sums of rows,
/// equality rows and net fits thrown in.
class Dice {
public:
  explicit Dice(unsigned seed) : engine_(seed) {}
  int whole(int from, int to) { return std::uniform_int_distribution<int>(from, to)(engine_); }
  bool chance(double p) { return real(0.0, 1.0) < p; }
  double real(double from, double to) {
    return std::uniform_real_distribution<double>(from, to)(engine_);
  }
  Matrix matrix(Eigen::Index r, Eigen::Index c) {
    return Matrix::NullaryExpr(r, c, [this] { return real(-1.0, 1.0); });
  }

private:
  std::mt19937 engine_;
};

ContactProblem random_problem(Dice& dice) {
  const Eigen::Index n = dice.whole(1, 8);
  const Eigen::Index m = dice.whole(0, 3);
  const Eigen::Index N = dice.whole(1, 9); // fewer than rows: semidefinite W
  const Matrix F = dice.matrix(N, N);      // S^+ = F F^T on the elastic freedoms
  Matrix G = dice.matrix(n, N);
  Matrix B = dice.matrix(n, m);
  Vector g0 = dice.matrix(n, 1);
  Vector f = dice.matrix(N, 1);
  Vector h = dice.matrix(m, 1);
  if (m > 0 && dice.chance(0.6)) { // loads that some rows can take
    h = -B.transpose() * dice.matrix(n, 1).cwiseAbs();
  }
  if (dice.chance(0.3)) {
    g0.setZero(); // net fit
    f *= dice.chance(0.5) ? 0.0 : 1.0;
  }
  if (dice.chance(0.1)) {
    G.setZero(); // rigid bodies
  }
  for (Eigen::Index i = 1; i < n; ++i) {
    const Eigen::Index k = dice.whole(0, static_cast<int>(i) - 1);
    if (dice.chance(0.15)) { // a twin, now and then further away
      G.row(i) = G.row(k);
      B.row(i) = B.row(k);
      g0(i) = g0(k) + (dice.chance(0.3) ? dice.real(0.0, 1.0) : 0.0);
    } else if (i > 1 && dice.chance(0.1)) { // the sum of two
      const Eigen::Index l = dice.whole(0, static_cast<int>(i) - 1);
      G.row(i) = G.row(k) + G.row(l);
      B.row(i) = B.row(k) + B.row(l);
      g0(i) = g0(k) + g0(l);
    }
  }
  ContactProblem p;
  p.W = G * F * F.transpose() * G.transpose();
  p.W = (0.5 * (p.W + p.W.transpose())).eval();
  p.B = B;
  p.b = g0 + G * F * (F.transpose() * f);
  p.h = h;
  p.equality.assign(at(n), false);
  if (dice.chance(0.3)) {
    p.equality[at(dice.whole(0, static_cast<int>(n) - 1))] = true;
    p.equality[at(dice.whole(0, static_cast<int>(n) - 1))] = true;
  }
  return p;
}

/// The same problem in other units of force and length.
ContactProblem in_units(ContactProblem p, double force, double length) {
  p.W *= length / force;
  p.b *= length;
  p.h *= force;
  return p;
}

void check_unheld(const ContactProblem& p, const Vector& d) {
  ASSERT_EQ(d.size(), p.h.size());
  EXPECT_GT(p.h.dot(d), 1e-10 * p.h.norm());
  const Vector opening = p.B * d;
  for (Eigen::Index i = 0; i < opening.size(); ++i) {
    EXPECT_GT(opening(i), -1e-9);
    if (p.equality[at(i)]) {
      EXPECT_LT(opening(i), 1e-9);
    }
  }
}

std::vector<bool> random_start(Dice& dice, Eigen::Index n) {
  std::vector<bool> start(at(n));
  for (Eigen::Index i = 0; i < n; ++i) {
    start[at(i)] = dice.chance(0.5);
  }
  return start;
}

TEST(ContactQp, CyclingMatrixFromEveryStart) {
  // plain flipping of all violated rows cycles from six of the eight starts
  Matrix W(3, 3);
  W << 4, 5, -5, 5, 9, -5, -5, -5, 7;
  const ContactProblem p = problem_of(W, Eigen::Vector3d(-2, -1, 3));
  for (unsigned set = 0; set < 8; ++set) {
    const ContactSolution s = solve(p, {(set & 1U) != 0, (set & 2U) != 0, (set & 4U) != 0});
    EXPECT_EQ(s.status, ContactStatus::solved);
    EXPECT_NEAR(s.lambda(0), 0.5, 1e-15);
    EXPECT_EQ(s.lambda(1), 0.0);
    EXPECT_EQ(s.lambda(2), 0.0);
    EXPECT_EQ(s.closed, std::vector<bool>({true, false, false}));
    EXPECT_LE(s.block_iterations + s.pivots, 10);
  }
}

TEST(ContactQp, RandomProblemsAgreeWithEnumeration) {
  const int tries = std::getenv("SPRICKA_FULL") == nullptr ? 300 : 10000;
  int solved = 0;
  int fallbacks = 0;
  for (int seed = 0; seed < tries; ++seed) {
    SCOPED_TRACE(seed);
    Dice dice(static_cast<unsigned>(seed));
    const ContactProblem plain = random_problem(dice);
    const std::optional<ContactSolution> reference = enumerate(plain);
    const double force = std::pow(10.0, dice.whole(-6, 6));
    const double length = std::pow(10.0, dice.whole(-6, 6));
    const ContactProblem p = in_units(plain, force, length);
    const ContactSolution s = solve(p);
    if (!reference) {
      EXPECT_NE(s.status, ContactStatus::solved);
      EXPECT_NE(s.status, ContactStatus::max_iterations);
      if (s.status == ContactStatus::unheld_mode) {
        check_unheld(p, s.unheld);
      }
      continue;
    }
    ASSERT_EQ(s.status, ContactStatus::solved);
    ++solved;
    fallbacks += s.pivots > 0 ? 1 : 0;
    EXPECT_LT(violation(p, s, length), 1e-10);
    EXPECT_LT(s.residual, 1e-10);
    // what the forces do is unique, the forces of redundant rows are not
    const Vector opened = p.W * s.lambda;
    const Vector expected = length * plain.W * reference->lambda;
    const Vector terms = length * plain.W.cwiseAbs() * reference->lambda.cwiseAbs();
const double size = length + p.b.cwiseAbs().maxCoeff() + terms.maxCoeff();
    EXPECT_LT((opened - expected).cwiseAbs().maxCoeff(), 1e-10 * size);
    const ContactSolution warm = solve(p, random_start(dice, p.b.size()));
    ASSERT_EQ(warm.status, ContactStatus::solved);
    EXPECT_LT((p.W * warm.lambda - opened).cwiseAbs().maxCoeff(), 1e-12 * size);
  }
  std::printf("%d of %d solved, %d of them by pivoting\n", solved, tries, fallbacks);
}

} // namespace
} // namespace spricka::solve
