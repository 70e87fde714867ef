// SPDX-License-Identifier: GPL-3.0-or-later
#include "solve/parametric.hpp"

#include <cmath>
#include <cstdlib>
#include <gtest/gtest.h>
#include <random>
#include <vector>

namespace spricka::solve {
namespace {

using base::Matrix;
using base::Vector;

std::size_t at(Eigen::Index i) {
  return static_cast<std::size_t>(i);
}

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

/// Elastic freedoms with compliance C = F F^T, rows G, loads f + t df, rigid modes felt by B. The
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

const PathSegment& segment_at(const SolutionPath& path, double t) {
  std::size_t k = 0;
  while (k + 1 < path.segments.size() && path.segments[k].to < t) {
    ++k;
  }
  return path.segments[k];
}

Vector value_at(const SolutionPath& path, double t) {
  const PathSegment& s = segment_at(path, t);
  return s.value + (t - s.from) * s.slope;
}

/// Largest functional on the path, what differences are measured by.
double size_of(const SolutionPath& path, const ParametricProblem& p) {
  double size = p.f0.cwiseAbs().maxCoeff() + p.df.cwiseAbs().maxCoeff();
  for (const PathSegment& s : path.segments) {
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
    EXPECT_LT(error, 1e-6) << t;
  }
  for (std::size_t k = 1; k < path.segments.size(); ++k) { // continuous
    const PathSegment& s = path.segments[k - 1];
    const Vector jump = s.value + (s.to - s.from) * s.slope - path.segments[k].value;
    EXPECT_LT(jump.cwiseAbs().maxCoeff(), 1e-6 * size);
    EXPECT_EQ(s.to, path.segments[k].from);
  }
}

TEST(Parametric, RandomPathsAgreeWithPointSolutions) {
  const int tries = std::getenv("SPRICKA_FULL") == nullptr ? 400 : 20000;
  int complete = 0;
  int cut = 0;
  int kinks = 0;
  int gave_up = 0;
  Tally tally;
  for (int seed = 0; seed < tries; ++seed) {
    SCOPED_TRACE(seed);
    Dice dice(static_cast<unsigned>(seed));
    const ParametricProblem p = problem_of(random_body(dice, seed % 4 == 0 ? 30 : 8));
    const SolutionPath path = follow_path(p, 0.0, 1.5, PathSettings{}, {});
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
  EXPECT_LE(tally.wrong, tally.points / 50000);
  EXPECT_LT(tally.loose, tally.points / 250);
  EXPECT_GT(complete, tries / 3);
  EXPECT_GT(cut, tries / 100);
  EXPECT_GT(kinks, tries);
}

} // namespace
} // namespace spricka::solve
