// SPDX-License-Identifier: GPL-3.0-or-later
#include "dice.hpp"
#include "solve/contact_qp.hpp"
#include "solve/parametric.hpp"
#include "tests/places.hpp"

#include <cmath>
#include <cstdlib>
#include <gtest/gtest.h>
#include <vector>

namespace spricka::solve::test_parametric {
namespace {

using base::Matrix;
using base::Vector;
using test::Dice;

std::size_t at(Eigen::Index i) {
  return static_cast<std::size_t>(i);
}

/// Elastic freedoms with compliance C = F F^T, rows G, loads f + t df, rigid modes that open B. The
/// functionals are elastic displacements, which are unique however redundant the rows are.
struct Body {
  Matrix F, G, B;
  Vector gap, dgap; ///< [n]
  Vector f, df;     ///< [N]
  Vector h, dh;     ///< [m]
  Matrix watched;   ///< [k, N]
  std::vector<bool> equality;
};

ParametricProblem problem_of(const Body& body) {
  const Matrix GC = body.G * body.F * body.F.transpose();
  const Matrix rC = body.watched * body.F * body.F.transpose();
  ParametricProblem p;
  p.at_zero.W = GC * body.G.transpose();
  p.at_zero.W = (0.5 * (p.at_zero.W + p.at_zero.W.transpose())).eval();
  p.at_zero.B = body.B;
  p.at_zero.b = body.gap + GC * body.f;
  p.at_zero.h = body.h;
  p.at_zero.equality = body.equality;
  p.db = body.dgap + GC * body.df;
  p.dh = body.dh;
  p.of_force = rC * body.G.transpose();
  p.of_mode = Matrix::Zero(body.watched.rows(), body.B.cols());
  p.f0 = rC * body.f;
  p.df = rC * body.df;
  return p;
}

Body random_body(Dice& dice, int largest) {
  const Eigen::Index n = dice.whole(1, largest);
  const Eigen::Index m = dice.whole(0, 3);
  const Eigen::Index N = dice.whole(1, largest + 2); // fewer than rows: semidefinite W
  Body body{dice.matrix(N, N),
            dice.matrix(n, N),
            dice.matrix(n, m),
            dice.matrix(n, 1),
            dice.matrix(n, 1),
            dice.matrix(N, 1),
            dice.matrix(N, 1),
            dice.matrix(m, 1),
            dice.matrix(m, 1),
            dice.matrix(2, N),
            std::vector<bool>(at(n), false)};
  if (m > 0 && dice.chance(0.7)) { // loads that the rows can take
    body.h = -body.B.transpose() * dice.matrix(n, 1).cwiseAbs();
    body.dh = -body.B.transpose() * dice.matrix(n, 1).cwiseAbs() - body.h;
  }
  if (dice.chance(0.4)) { // fits that do not change
    body.dgap.setZero();
  }
  if (dice.chance(0.3)) { // net fit
    body.gap.setZero();
    body.f *= dice.chance(0.5) ? 0.0 : 1.0;
    body.h *= dice.chance(0.5) ? 0.0 : 1.0;
  }
  for (Eigen::Index i = 1; i < n; ++i) {
    const Eigen::Index k = dice.whole(0, static_cast<int>(i) - 1);
    if (dice.chance(0.15)) { // a twin, now and then one that stands elsewhere
      body.G.row(i) = body.G.row(k);
      body.B.row(i) = body.B.row(k);
      body.gap(i) = body.gap(k) + (dice.chance(0.3) ? dice.real(0.0, 0.5) : 0.0);
      body.dgap(i) = body.dgap(k) + (dice.chance(0.5) ? dice.real(-0.5, 0.5) : 0.0);
    } else if (i > 1 && dice.chance(0.1)) { // the sum of two
      const Eigen::Index l = dice.whole(0, static_cast<int>(i) - 1);
      body.G.row(i) = body.G.row(k) + body.G.row(l);
      body.B.row(i) = body.B.row(k) + body.B.row(l);
      body.gap(i) = body.gap(k) + body.gap(l);
      body.dgap(i) = body.dgap(k) + body.dgap(l);
    }
  }
  if (dice.chance(0.25)) {
    body.equality[at(dice.whole(0, static_cast<int>(n) - 1))] = true;
  }
  return body;
}

struct Point {
  ContactStatus status = ContactStatus::solved;
  Vector value;
};

Point solve_point(const ParametricProblem& p, double t) {
  ContactProblem problem = p.at_zero;
  problem.b += t * p.db;
  problem.h += t * p.dh;
  const ContactSolution s = solve_contact(problem, ContactSettings{}, {});
  Point point{s.status, {}};
  if (s.status == ContactStatus::solved) {
    point.value = p.f0 + t * p.df + p.of_force * s.lambda + p.of_mode * s.alpha;
  }
  return point;
}

const SolutionPathSegment& segment_at(const SolutionPath& path, double t) {
  std::size_t k = 0;
  while (k + 1 < path.segments.size() && path.segments[k].to < t) {
    ++k;
  }
  return path.segments[k];
}

Vector value_at(const SolutionPath& path, double t) {
  const SolutionPathSegment& s = segment_at(path, t);
  return s.value + (t - s.from) * s.slope;
}

/// Largest functional on the path, what differences are measured by.
double size_of(const SolutionPath& path, const ParametricProblem& p) {
  double size = p.f0.cwiseAbs().maxCoeff() + p.df.cwiseAbs().maxCoeff();
  for (const SolutionPathSegment& s : path.segments) {
    size = std::max(size, s.value.cwiseAbs().maxCoeff());
  }
  return size;
}

/// Point solutions within the path: of the random matrices some are near singular, where both ways
/// lose digits.
struct Tally {
  int points = 0, loose = 0, wrong = 0;
};

void compare(const SolutionPath& path, const ParametricProblem& p, Dice& dice, Tally& tally) {
  const double size = size_of(path, p);
  for (int k = 0; k < 12; ++k) {
    const double t = dice.real(0.0, 1.5);
    if (std::abs(t - path.end) < 1e-6) {
      continue;
    }
    const Point point = solve_point(p, t);
    if (t > path.end) {
      EXPECT_NE(point.status, ContactStatus::solved) << t << " beyond " << path.end;
      continue;
    }
    if (point.status != ContactStatus::solved) {
      ++tally.wrong;
      continue;
    }
    const double error = (value_at(path, t) - point.value).cwiseAbs().maxCoeff() / size;
    ++tally.points;
    tally.loose += error > 1e-11 ? 1 : 0;
    EXPECT_LT(error, 1e-5) << t;
  }
  for (std::size_t k = 1; k < path.segments.size(); ++k) { // continuous
    const SolutionPathSegment& s = path.segments[k - 1];
    const Vector jump = s.value + (s.to - s.from) * s.slope - path.segments[k].value;
    EXPECT_LT(jump.cwiseAbs().maxCoeff(), 1e-5 * size);
    EXPECT_EQ(s.to, path.segments[k].from);
  }
}

TEST(Parametric, RandomPathsAgreeWithPointSolutions) {
  const int tries = !spricka::test::full_size() ? 400 : 20000;
  int complete = 0;
  int cut = 0;
  int kinks = 0;
  int gave_up = 0;
  Tally tally;
  for (int seed = 0; seed < tries; ++seed) {
    SCOPED_TRACE(seed);
    Dice dice(static_cast<unsigned>(seed));
    const ParametricProblem p = problem_of(random_body(dice, seed % 4 == 0 ? 30 : 8));
    const SolutionPath path = follow_solution_path(p, 0.0, 1.5, SolutionPathSettings{}, {});
    if (path.status == PathStatus::no_start) {
      ASSERT_NE(solve_point(p, 0.0).status, ContactStatus::solved);
      continue;
    }
    gave_up += path.status == PathStatus::unfinished || path.status == PathStatus::drift ? 1 : 0;
    complete += path.status == PathStatus::complete ? 1 : 0;
    cut += path.status == PathStatus::unheld_mode || path.status == PathStatus::inconsistent;
    if (path.segments.empty()) {
      continue;
    }
    kinks += static_cast<int>(path.segments.size()) - 1;
    if (path.status != PathStatus::drift) {
      compare(path, p, dice, tally);
    }
  }
  EXPECT_LE(gave_up, tries / 5000);
  EXPECT_EQ(tally.wrong, 0);
  EXPECT_LT(tally.loose, tally.points / 250);
  EXPECT_GT(complete, tries / 3);
  EXPECT_GT(cut, tries / 100);
  EXPECT_GT(kinks, tries);
}

/// n springs side by side on a half plane, as it were: compliance that falls off with distance,
/// gaps that grow from the middle on, so that contact spreads row by row. The first half of the
/// rows mirrors the second. One functional: a weighted sum of forces.
ParametricProblem row_of_springs(int n) {
  ParametricProblem p;
  p.at_zero.W.resize(n, n);
  p.at_zero.b.resize(n);
  p.db.resize(n);
  p.of_force.resize(1, n);
  for (int i = 0; i < n; ++i) {
    const double x = (i - 0.5 * (n - 1)) / n;
    for (int j = 0; j < n; ++j) {
      p.at_zero.W(i, j) = std::exp(-10.0 * std::abs(i - j) / n);
    }
    p.at_zero.b(i) = x * x - 0.01;
    p.db(i) = -0.5 * std::exp(-8.0 * x * x);
    p.of_force(0, i) = 1.0 + x * x;
  }
  p.at_zero.B.resize(n, 0);
  p.at_zero.h.resize(0);
  p.dh.resize(0);
  p.of_mode.resize(1, 0);
  p.at_zero.equality.assign(at(n), false);
  p.f0 = p.df = Vector::Zero(1);
  return p;
}

ParametricProblem backwards(ParametricProblem p) {
  p.at_zero.b += p.db;
  p.at_zero.h += p.dh;
  p.f0 += p.df;
  p.db = -p.db;
  p.dh = -p.dh;
  p.df = -p.df;
  return p;
}

TEST(Parametric, MirrorImagesCloseTogether) {
  const int n = 120;
  const ParametricProblem p = row_of_springs(n);
  const SolutionPath path = follow_solution_path(p, 0.0, 1.0, SolutionPathSettings{}, {});
  ASSERT_EQ(path.status, PathStatus::complete);
  EXPECT_GT(path.segments.size(), 20U);
  std::vector<bool> closed = path.closed;
  std::size_t k = 0;
  for (std::size_t s = 0; s < path.segments.size(); ++s) {
    for (; k < path.changes.size() && path.changes[k].segment == s; ++k) {
      closed[at(path.changes[k].row)] = path.changes[k].closes;
    }
    for (int i = 0; i < n; ++i) {
      ASSERT_EQ(closed[at(i)], closed[at(n - 1 - i)]) << "segment " << s << " row " << i;
    }
  }
  for (int i = 0; i <= 40; ++i) {
    const double t = i / 40.0;
    EXPECT_NEAR(value_at(path, t)(0), solve_point(p, t).value(0), 1e-11 * size_of(path, p));
  }
}

TEST(Parametric, TheWayBackHasTheSameBreakpoints) {
  const ParametricProblem p = row_of_springs(90);
  const SolutionPath up = follow_solution_path(p, 0.0, 1.0, SolutionPathSettings{}, {});
  const SolutionPath down =
      follow_solution_path(backwards(p), 0.0, 1.0, SolutionPathSettings{}, {});
  ASSERT_EQ(up.segments.size(), down.segments.size());
  const std::size_t n = up.segments.size();
  for (std::size_t k = 0; k < n; ++k) {
    EXPECT_NEAR(up.segments[k].from, 1.0 - down.segments[n - 1 - k].to, 1e-10);
    EXPECT_NEAR(up.segments[k].slope(0), -down.segments[n - 1 - k].slope(0),
                1e-9 * std::abs(up.segments[k].slope(0)) + 1e-11);
  }
}

TEST(Parametric, ScaledLoadsAndGapsScaleThePath) {
  const ParametricProblem p = row_of_springs(60);
  const SolutionPath one = follow_solution_path(p, 0.0, 1.0, SolutionPathSettings{}, {});
  for (const double s : {1e-3, 0.3, 1e3}) {
    ParametricProblem q = p;
    q.at_zero.b *= s;
    q.db *= s;
    const SolutionPath other = follow_solution_path(q, 0.0, 1.0, SolutionPathSettings{}, {});
    ASSERT_EQ(one.segments.size(), other.segments.size());
    for (std::size_t k = 0; k < one.segments.size(); ++k) {
      EXPECT_NEAR(one.segments[k].from, other.segments[k].from, 1e-11);
      EXPECT_NEAR(s * one.segments[k].value(0), other.segments[k].value(0),
                  1e-11 * s * size_of(one, p));
    }
  }
}

TEST(Parametric, FromNothingAtAllThePathIsOneLine) {
  // all rows g = lambda = 0 at t = 0: a net fit without load; everything grows in proportion
  ParametricProblem p = row_of_springs(80);
  p.db = p.at_zero.b + 0.5 * p.db;
  p.at_zero.b.setZero();
  const SolutionPath path = follow_solution_path(p, 0.0, 2.0, SolutionPathSettings{}, {});
  ASSERT_EQ(path.status, PathStatus::complete);
  EXPECT_EQ(path.segments.size(), 1U);
  EXPECT_NEAR(path.segments[0].value(0), 0.0, 1e-14);
  const double at_one = solve_point(p, 1.0).value(0);
  EXPECT_GT(at_one, 0.0);
  EXPECT_NEAR(value_at(path, 0.7)(0), 0.7 * at_one, 1e-11 * at_one);
}

TEST(Parametric, NetFitBehindAPressFit) {
  // the second half of the rows just touches without force until t > 0 moves it
  ParametricProblem p = row_of_springs(80);
  for (int i = 0; i < 80; ++i) {
    for (int j = 0; j < 80; ++j) {
      p.at_zero.W(i, j) *= (i < 40) == (j < 40) ? 1.0 : 0.0;
    }
    p.at_zero.b(i) = i < 40 ? -0.1 : 0.0;
    p.db(i) = i < 40 ? 0.05 : -0.02 * std::sin(0.3 * i);
  }
  const SolutionPath path = follow_solution_path(p, 0.0, 1.0, SolutionPathSettings{}, {});
  ASSERT_EQ(path.status, PathStatus::complete);
  for (int i = 0; i <= 20; ++i) {
    const double t = i / 20.0;
    EXPECT_NEAR(value_at(path, t)(0), solve_point(p, t).value(0), 1e-11 * size_of(path, p)) << t;
  }
}

TEST(Parametric, OneTwinHandsOverToTheOther) {
  // u = c (f + lambda_1 + lambda_2), g_i = u + a_i(t): the nearer stop holds, so -u is the least
  // a_i, with a kink where they meet at t = 0.5; redundant there
  ParametricProblem p;
  const double c = 2.0;
  p.at_zero.W = Matrix::Constant(2, 2, c);
  p.at_zero.B.resize(2, 0);
  p.at_zero.h.resize(0);
  p.dh.resize(0);
  p.at_zero.b = Eigen::Vector2d(-3.0 * c + 0.1, -3.0 * c + 0.2); // f = -3, a = 0.1, 0.2
  p.db = Eigen::Vector2d(0.3, 0.1);
  p.at_zero.equality.assign(2, false);
  p.of_force = Matrix::Constant(1, 2, c);
  p.of_mode.resize(1, 0);
  p.f0 = Vector::Constant(1, -3.0 * c);
  p.df = Vector::Zero(1);
  const SolutionPath path = follow_solution_path(p, 0.0, 1.0, SolutionPathSettings{}, {});
  ASSERT_EQ(path.status, PathStatus::complete);
  ASSERT_EQ(path.segments.size(), 2U);
  EXPECT_NEAR(path.segments[1].from, 0.5, 1e-14);
  EXPECT_NEAR(value_at(path, 0.25)(0), -0.175, 1e-14);
  EXPECT_NEAR(value_at(path, 1.0)(0), -0.3, 1e-14);
}

TEST(Parametric, AModeThatIsLetGoIsNamedAndNothingExtrapolated) {
  // a body on two stops, pressed by 1 - t: at t = 1 nothing holds it any more
  ParametricProblem p;
  p.at_zero.W = Eigen::Vector2d(0.5, 0.5).asDiagonal();
  p.at_zero.B = Matrix::Constant(2, 1, 1.0);
  p.at_zero.h = Vector::Constant(1, -1.0);
  p.dh = Vector::Constant(1, 1.0);
  p.at_zero.b = Vector::Zero(2);
  p.db = Vector::Zero(2);
  p.at_zero.equality.assign(2, false);
  p.of_force = Matrix::Constant(1, 2, 1.0);
  p.of_mode = Matrix::Zero(1, 1);
  p.f0 = p.df = Vector::Zero(1);
  const SolutionPath path = follow_solution_path(p, 0.0, 3.0, SolutionPathSettings{}, {});
  EXPECT_EQ(path.status, PathStatus::unheld_mode);
  EXPECT_NEAR(path.end, 1.0, 1e-12);
  ASSERT_EQ(path.unheld.size(), 1);
  EXPECT_NEAR(path.unheld(0), 1.0, 1e-14); // the way the stops open
  EXPECT_NEAR(value_at(path, 0.25)(0), 0.75, 1e-14);
}

TEST(Parametric, ListOfPivotsAndFreshFactorsAgreeAndRepeatToTheBit) {
  const ParametricProblem p = row_of_springs(150);
  SolutionPathSettings often;
  often.refactor = 7;
  SolutionPathSettings never;
  never.refactor = 100000;
  const SolutionPath a = follow_solution_path(p, 0.0, 1.0, often, {});
  const SolutionPath b = follow_solution_path(p, 0.0, 1.0, never, {});
  const SolutionPath again = follow_solution_path(p, 0.0, 1.0, never, {});
  EXPECT_GT(a.factorisations, 5);
  EXPECT_LT(b.factorisations, 3);
  ASSERT_EQ(a.segments.size(), b.segments.size());
  ASSERT_EQ(b.segments.size(), again.segments.size());
  for (std::size_t k = 0; k < a.segments.size(); ++k) {
    EXPECT_NEAR(a.segments[k].from, b.segments[k].from, 1e-11);
    EXPECT_NEAR(a.segments[k].value(0), b.segments[k].value(0), 1e-11 * size_of(a, p));
    EXPECT_EQ(b.segments[k].from, again.segments[k].from);
    EXPECT_EQ(b.segments[k].slope(0), again.segments[k].slope(0));
  }
}

} // namespace
} // namespace spricka::solve::test_parametric
