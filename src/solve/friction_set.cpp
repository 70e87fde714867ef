// SPDX-License-Identifier: GPL-3.0-or-later
#include "solve/friction_set.hpp"
#include "base/index.hpp"
#include "solve/blas.hpp"

#include <algorithm>
#include <cmath>

namespace spricka::solve {

using base::at;

namespace {

// Where nothing can move along a tangent its compliance is round-off, and the row has no friction.
constexpr double no_freedom = 1e-9; ///< of the normal row's scale: nothing moves along the tangent
// Largest error of gaps and balance, over their scales, at which springs are out of an answer.
constexpr double solved_to = 1e-10;
constexpr int refinements = 3;

/// The rows whose gap or slip is zero, and what a force on each brings along on its tangent.
struct ActiveRows {
  std::vector<int> row;
  std::vector<int> follower; ///< tangent that slips with it, or -1
  std::vector<double> share; ///< force on the follower per force on the row

  [[nodiscard]] int size() const { return static_cast<int>(row.size()); }
  void add(int r, int t = -1, double s = 0.0) {
    row.push_back(r);
    follower.push_back(t);
    share.push_back(s);
  }
};

// The unknowns of the states (solve.22): a sticking unit has two forces, a sliding one only its
// pressure, which brings the shear of its cone along.
ActiveRows active_rows(const ScaledFrictionProblem& problem, const std::vector<SlipState>& touch) {
  ActiveRows active;
  for (const int i : problem.fixed) {
    active.add(i);
  }
  for (const ScaledFrictionProblem::FrictionUnit& u : problem.units) {
    const SlipState state = touch[at(u.normal)];
    if (state == SlipState::open) {
      continue;
    }
    if (u.tangent < 0 || state == SlipState::stick) {
      active.add(u.normal);
      if (u.tangent >= 0) {
        active.add(u.tangent);
      }
    } else {
      active.add(u.normal, u.tangent, state == SlipState::forward ? -u.mu : u.mu);
    }
  }
  return active;
}

/// LU factors of the equations: gaps of the active rows, balance of the modes.
class Equations {
public:
  Equations(const ScaledFrictionProblem& problem, const ActiveRows& active)
      : a_(active.size()), m_(problem.mode_count()), K_(a_ + m_, a_ + m_) {
    base::Vector column(problem.rows());
    for (int c = 0; c < a_; ++c) {
      const int i = active.row[at(c)];
      column = problem.W.col(i);
      // A column is what a force does together with the shear that follows it; a row asks for the
      // gap of one row only. So the matrix is not symmetric.
      base::Vector opened = problem.B.row(i).transpose();
      if (const int t = active.follower[at(c)]; t >= 0) {
        column += active.share[at(c)] * problem.W.col(t);
        opened += active.share[at(c)] * problem.B.row(t).transpose();
      }
      for (int r = 0; r < a_; ++r) {
        K_(r, c) = column(active.row[at(r)]);
      }
      K_(c, c) += row_spring;
      K_.block(a_, c, m_, 1) = opened;
      K_.block(c, a_, 1, m_) = problem.B.row(i);
    }
    // The anchoring springs of (solve.24), in the units of the scaled modes.
    K_.bottomRightCorner(m_, m_) = -mode_spring * base::Matrix::Identity(m_, m_);
    regular_ = size() == 0 || blas::factorise_lu(size(), {K_.data(), size()}, order_);
  }
  [[nodiscard]] bool regular() const { return regular_; }
  [[nodiscard]] int size() const { return a_ + m_; }
  void solve(base::Matrix& x) const {
    blas::solve_lu(size(), static_cast<int>(x.cols()), {K_.data(), size()}, order_,
                   {x.data(), size()});
  }

private:
  int a_;
  int m_;
  base::Matrix K_;
  std::vector<int> order_;
  bool regular_ = false;
};

/// Adds a solution of the equations and finds the gaps again.
void add(const ScaledFrictionProblem& problem, const ActiveRows& active, const base::Matrix& x,
         SlipStateSolution& s) {
  for (int c = 0; c < active.size(); ++c) {
    s.lambda(active.row[at(c)]) += x(c, 0);
    if (const int t = active.follower[at(c)]; t >= 0) {
      s.lambda(t) += active.share[at(c)] * x(c, 0);
    }
  }
  s.alpha += x.col(0).tail(problem.mode_count());
  const int n = problem.rows();
  // Gaps are summed from forces and motions again, not carried along: what refinement corrects is
  // the error of these very sums.
  base::Vector opened(n);
  blas::gemm({.m = n, .n = 1, .k = n}, {problem.W.data(), n}, {s.lambda.data(), n},
             {opened.data(), n});
  const base::Vector moved = problem.B * s.alpha;
  s.gap = problem.b + opened + moved;
  double size = s.lambda.size() > 0 ? s.lambda.cwiseAbs().maxCoeff() : 0.0;
  s.force_scale = std::max(size, problem.force_floor);
  for (const int i : active.row) {
    // In these units a gap is the force that closes it; a thousandth keeps the scale up where
    // forces cancel.
    s.force_scale = std::max(s.force_scale, 1e-3 * std::abs(problem.b(i)));
  }
  if (n > 0) {
    size = std::max({size, opened.cwiseAbs().maxCoeff(), moved.cwiseAbs().maxCoeff()});
  }
  s.gap_scale = problem.b.cwiseAbs().array() + size;
}

base::Vector balance_of(const ScaledFrictionProblem& problem, const SlipStateSolution& s) {
  return problem.h + problem.B.transpose() * s.lambda;
}

// Largest error of the balance of a mode, over the size of the terms that it sums.
double unbalanced(const ScaledFrictionProblem& problem, const SlipStateSolution& s) {
  const base::Vector left = balance_of(problem, s);
  const base::Vector size =
      problem.h.cwiseAbs() + problem.B.cwiseAbs().transpose() * s.lambda.cwiseAbs();
  double worst = 0.0;
  for (int j = 0; j < problem.mode_count(); ++j) {
    worst = std::max(worst, left(j) == 0.0 ? 0.0 : std::abs(left(j)) / (size(j) + s.force_scale));
  }
  return worst;
}

// Largest gap or slip that is left on rows where it should be zero, over its scale.
double open_error(const ActiveRows& active, const SlipStateSolution& s) {
  double worst = 0.0;
  for (const int i : active.row) {
    worst = std::max(worst, divide_by_scale(std::abs(s.gap(i)), s.gap_scale(i)));
  }
  return worst;
}

} // namespace

ScaledFrictionProblem scale_friction_problem(const ControllableProblem& held,
                                             const std::vector<FrictionRow>& friction,
                                             double load_scale) {
  ScaledFrictionProblem p;
  const int n = held.rows();
  const double root = std::sqrt(held.tau);
  base::Vector inverse(n);
  for (int i = 0; i < n; ++i) {
    // Rows without compliance and modes get zeros: they stay in place, so that numbers of rows
    // hold.
    inverse(i) = held.d(i) > 0.0 ? 1.0 / held.d(i) : 0.0;
  }
  p.W = inverse.asDiagonal() * held.W * inverse.asDiagonal();
  p.B = inverse.asDiagonal() * held.B * root;
  p.b = inverse.asDiagonal() * held.b;
  p.h = held.h * root;
  // The scale of forces never falls below the loads on modes: where no row presses yet there is no
  // other.
  p.force_floor = p.h.size() > 0 ? std::max(p.h.cwiseAbs().maxCoeff(), load_scale * root) : 0.0;
  std::vector<int> tangent(std::size_t(n), -1);
  std::vector<double> mu(std::size_t(n), 0.0);
  std::vector<bool> slips(std::size_t(n), false);
  for (const FrictionRow& f : friction) {
    slips[at(f.tangent)] = true;
    if (held.d(f.tangent) > no_freedom * held.d(f.normal) && f.mu > 0.0) {
      tangent[at(f.normal)] = f.tangent;
      // Forces are multiplied by d, each by that of its own row: so the ratio of two of them
      // changes.
      mu[at(f.normal)] = f.mu * held.d(f.tangent) * inverse(f.normal);
    }
  }
  for (int i = 0; i < n; ++i) {
    if (!(held.d(i) > 0.0) || slips[at(i)]) {
      continue;
    }
    if (held.equality[at(i)]) {
      p.fixed.push_back(i);
    } else {
      p.units.push_back({i, tangent[at(i)], mu[at(i)]});
    }
  }
  return p;
}

SlipStateSolution solve_slip_states(const ScaledFrictionProblem& problem,
                                    const std::vector<SlipState>& touch,
                                    const base::Vector& anchor) {
  const ActiveRows active = active_rows(problem, touch);
  const int a = active.size();
  const int m = problem.mode_count();
  SlipStateSolution s;
  s.lambda = base::Vector::Zero(problem.rows());
  s.alpha = base::Vector::Zero(m);
  s.gap = problem.b;
  s.gap_scale = problem.b.cwiseAbs();
  const Equations equations(problem, active);
  if (!equations.regular()) {
    return s;
  }
  base::Matrix x(a + m, 1);
  for (int r = 0; r < a; ++r) {
    x(r, 0) = -problem.b(active.row[at(r)]);
  }
  // (solve.24): the springs pull towards the anchor, not towards zero.
  x.col(0).tail(m) = -problem.h - mode_spring * anchor;
  equations.solve(x);
  add(problem, active, x, s);
  s.regular = s.gap.allFinite();
  // Residuals leave the springs out, the factors have them: the steps converge to the answer
  // without springs where the rows hold every mode, and do not where a motion is free.
  SlipStateSolution exact = s;
  for (int k = 0; k < refinements && s.regular; ++k) {
    for (int r = 0; r < a; ++r) {
      x(r, 0) = -exact.gap(active.row[at(r)]);
    }
    x.col(0).tail(m) = -balance_of(problem, exact);
    equations.solve(x);
    add(problem, active, x, exact);
  }
  exact.held = exact.gap.allFinite() && unbalanced(problem, exact) < solved_to &&
               open_error(active, exact) < solved_to;
  return exact.held ? exact : s;
}

int update_slip_states(const ScaledFrictionProblem& problem, const SlipStateSolution& s,
                       double tolerance, std::vector<SlipState>& touch) {
  int changed = 0;
  // The rules of (solve.22) that rows change their states by, all of them at once.
  const double force = tolerance * s.force_scale;
  for (const ScaledFrictionProblem::FrictionUnit& u : problem.units) {
    SlipState& state = touch[at(u.normal)];
    const SlipState before = state;
    const double pressure = s.lambda(u.normal);
    const double slip = u.tangent < 0 ? 0.0 : s.gap(u.tangent);
    if (state == SlipState::open) {
      const double gap = s.gap(u.normal);
      if (gap < -tolerance * s.gap_scale(u.normal)) {
        // What is missing of the gap stands for the pressure that will close it, and the slip for
        // the shear that would stop it: in these units a row has a compliance of about 1.
        const bool runs = u.tangent >= 0 && std::abs(slip) > -u.mu * gap;
        state = !runs ? SlipState::stick : slip > 0.0 ? SlipState::forward : SlipState::backward;
      }
    } else if (pressure < -force) {
      state = SlipState::open;
    } else if (u.tangent >= 0 && state == SlipState::stick) {
      const double shear = s.lambda(u.tangent);
      if (std::abs(shear) > u.mu * pressure + force) {
        state = shear < 0.0 ? SlipState::forward : SlipState::backward;
      }
    } else if (u.tangent >= 0) {
      // Slip against the direction of the state would make friction drive it.
      const double along = state == SlipState::forward ? slip : -slip;
      if (along < -tolerance * s.gap_scale(u.tangent)) {
        state = SlipState::stick;
      }
    }
    if (u.tangent >= 0) {
      touch[at(u.tangent)] = state;
    }
    changed += state != before ? 1 : 0;
  }
  return changed;
}

double friction_residual(const ScaledFrictionProblem& problem, const SlipStateSolution& s,
                         const std::vector<SlipState>& touch) {
  // Conditions are those of (solve.14) and (solve.21), whatever equations the states stood for.
  double worst = unbalanced(problem, s);
  const auto gap_error = [&](int i, double error) {
    worst = std::max(worst, divide_by_scale(error, s.gap_scale(i)));
  };
  const auto force_error = [&](double error) {
    worst = std::max(worst, divide_by_scale(std::max(error, 0.0), s.force_scale));
  };
  for (const int i : problem.fixed) {
    gap_error(i, std::abs(s.gap(i)));
  }
  for (const ScaledFrictionProblem::FrictionUnit& u : problem.units) {
    const SlipState state = touch[at(u.normal)];
    const double gap = s.gap(u.normal);
    gap_error(u.normal, state == SlipState::open ? std::max(-gap, 0.0) : std::abs(gap));
    force_error(-s.lambda(u.normal));
    if (u.tangent < 0) {
      continue;
    }
    force_error(std::abs(s.lambda(u.tangent)) - u.mu * std::max(s.lambda(u.normal), 0.0));
    const double slip = s.gap(u.tangent);
    if (state == SlipState::stick) {
      gap_error(u.tangent, std::abs(slip));
    } else if (state != SlipState::open) {
      gap_error(u.tangent, std::max(state == SlipState::forward ? -slip : slip, 0.0));
    }
  }
  return std::isfinite(s.gap.sum() + s.lambda.sum()) ? worst : INFINITY;
}

InterfaceStiffness interface_stiffness(const ScaledFrictionProblem& problem,
                                       const base::Vector& anchor) {
  InterfaceStiffness face;
  // All rows as if they stuck: normals first, then tangents, equality rows last, where they are
  // held and do not appear in A.
  ActiveRows all;
  for (const ScaledFrictionProblem::FrictionUnit& u : problem.units) {
    all.add(u.normal);
  }
  for (const ScaledFrictionProblem::FrictionUnit& u : problem.units) {
    if (u.tangent >= 0) {
      all.add(u.tangent);
    }
  }
  face.rows = all.row;
  const int k = all.size();
  for (const int i : problem.fixed) {
    all.add(i);
  }
  const Equations equations(problem, all);
  face.regular = equations.regular();
  if (!face.regular) {
    return face;
  }
  const int m = problem.mode_count();
  base::Matrix x = base::Matrix::Zero(equations.size(), k + 1);
  // One column for a unit of each opening or slip, and one for gaps and loads as they are: forces
  // are theirs, modes are eliminated on the way.
  x.topLeftCorner(k, k).setIdentity();
  for (int r = 0; r < all.size(); ++r) {
    x(r, k) = -problem.b(all.row[at(r)]);
  }
  x.col(k).tail(m) = -problem.h - mode_spring * anchor;
  equations.solve(x);
  face.A = x.topLeftCorner(k, k);
  face.q = x.col(k).head(k);
  face.regular = x.allFinite();
  return face;
}

} // namespace spricka::solve
