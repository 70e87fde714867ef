// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/dense_solve.hpp"
#include "qp_problems.hpp"
#include "solve/held_problem.hpp"
#include "solve/mode_split.hpp"
#include "tests/places.hpp"

#include <cstdio>
#include <cstdlib>

namespace spricka::solve::test::test_contact_qp_random {
namespace {

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

/// The same problem in other units of force and length, its rows weighted by another area.
ContactProblem in_units(ContactProblem p, double force, double length, double area) {
  p.W *= area * area * length / force;
  p.B *= area;
  p.b *= area * length;
  p.h *= force;
  return p;
}

/// Whether every row clearly presses or clearly stands open and the forces are unique: then there
/// is one set of closed rows.
bool strict(const ContactProblem& p, const ContactSolution& s) {
  std::vector<Eigen::Index> A;
  const double force = s.lambda.cwiseAbs().maxCoeff();
  for (Eigen::Index i = 0; i < p.b.size(); ++i) {
    const bool presses = p.equality[at(i)] || s.lambda(i) > 1e-6 * force;
    if (!presses && s.gap(i) < 1e-6) {
      return false;
    }
    if (presses) {
      A.push_back(i);
    }
  }
  const auto a = static_cast<Eigen::Index>(A.size());
  Matrix M(a, a);
  for (Eigen::Index i = 0; i < a; ++i) {
    for (Eigen::Index j = 0; j < a; ++j) {
      M(i, j) = p.W(A[at(i)], A[at(j)]) + p.B.row(A[at(i)]).dot(p.B.row(A[at(j)]));
    }
  }
  return a == 0 || base::column_rank(M, 1e-7) == a;
}

// What the forces do is unique, the forces of redundant rows are not: openings, and through them
// the displacements, and the resultants on the modes must be those of the enumeration.
void check_against(const ContactProblem& plain, const ContactSolution& reference,
                   const ContactProblem& p, const ContactSolution& s, double opening) {
  EXPECT_LT(violation(p, s, opening), 1e-10);
  EXPECT_LT(s.residual, 1e-10);
  const Vector opened = p.W * s.lambda;
  const Vector expected = opening * plain.W * reference.lambda;
  const Vector terms = opening * (plain.W.cwiseAbs() * reference.lambda.cwiseAbs() +
                                  plain.B.cwiseAbs() * reference.alpha.cwiseAbs());
  const double size = opening + p.b.cwiseAbs().maxCoeff() + terms.maxCoeff();
  EXPECT_LT((opened - expected).cwiseAbs().maxCoeff(), 1e-10 * size);
  if (p.h.size() > 0) { // resultants: what loads the modes is carried
    const Vector carried = p.B.transpose() * s.lambda;
    const Vector parts = p.B.cwiseAbs().transpose() * s.lambda.cwiseAbs();
    EXPECT_LT((carried + p.h).cwiseAbs().maxCoeff(),
              1e-10 * (parts.maxCoeff() + p.h.cwiseAbs().maxCoeff()));
  }
  EXPECT_LE(s.block_iterations, 60);
  EXPECT_LE(s.pivots, 300);
  if (s.redundant == 0 && s.resting_modes == 0 && strict(plain, reference)) {
    const double force = reference.lambda.cwiseAbs().maxCoeff();
    for (Eigen::Index i = 0; i < p.b.size(); ++i) {
      EXPECT_EQ(s.closed[at(i)], plain.equality[at(i)] || reference.lambda(i) > 1e-6 * force) << i;
    }
  }
}

/// The problem without what little of the load acts on motions that no row feels, and is told.
ContactProblem without_left_over(ContactProblem p, const ContactSolution& s) {
  const Vector rest = p.h + p.B.transpose() * s.lambda;
  const double told = s.left_over * load_scale(p);
  if (s.left_over > 0.0 &&
      rest.norm() <= 1.01 * std::sqrt(static_cast<double>(p.h.size())) * told) {
    EXPECT_LE(s.left_over, resting_load);
    p.h -= rest;
  }
  return p;
}

TEST(ContactQp, RandomProblemsAgreeWithEnumeration) {
  const int tries = !spricka::test::full_size() ? 1000 : 10000;
  int solved = 0;
  int fallbacks = 0;
  int sharp = 0;
  for (int seed = 0; seed < tries; ++seed) {
    SCOPED_TRACE(seed);
    Dice dice(static_cast<unsigned>(seed));
    const ContactProblem plain = random_problem(dice);
    const std::optional<ContactSolution> reference = enumerate(plain);
    const double force = std::pow(10.0, dice.whole(-6, 6));
    const double length = std::pow(10.0, dice.whole(-6, 6));
    const double area = std::pow(10.0, dice.whole(-10, 10));
    const ContactProblem p = in_units(plain, force, length, area);
    const ContactSolution s = solve(p);
    if (!reference) {
      if (s.status == ContactStatus::solved) { // nearly parallel rows: forces of 1e10 can be right
        EXPECT_LT(violation(without_left_over(p, s), s, length * area), 1e-9) << s.left_over;
      }
      EXPECT_NE(s.status, ContactStatus::max_iterations);
      if (s.status == ContactStatus::unheld_mode) {
        check_unheld(p, s.unheld);
      }
      continue;
    }
    ASSERT_EQ(s.status, ContactStatus::solved);
    ++solved;
    fallbacks += s.pivots > 0 ? 1 : 0;
    sharp += strict(plain, *reference) ? 1 : 0;
    check_against(plain, *reference, p, s, length * area);
    for (const std::vector<bool>& start :
         {random_start(dice, p.b.size()), std::vector<bool>(at(p.b.size()), false)}) {
      const ContactSolution warm = solve(p, start);
      ASSERT_EQ(warm.status, ContactStatus::solved);
      const Vector opened = p.W * s.lambda;
      const double size = length * area + p.b.cwiseAbs().maxCoeff() + opened.cwiseAbs().maxCoeff() +
                          (p.W.cwiseAbs() * s.lambda.cwiseAbs()).maxCoeff() +
                          (p.B.cwiseAbs() * s.alpha.cwiseAbs()).sum();
      EXPECT_LT((p.W * warm.lambda - opened).cwiseAbs().maxCoeff(), 1e-12 * size);
    }
  }
  std::printf("%d of %d solved, %d of them by pivoting, %d with one set\n", solved, tries,
              fallbacks, sharp);
  EXPECT_GT(sharp, tries / 4);
}

} // namespace
} // namespace spricka::solve::test::test_contact_qp_random
