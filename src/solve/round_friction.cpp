// SPDX-License-Identifier: GPL-3.0-or-later
#include "solve/round_friction.hpp"

#include "base/index.hpp"
#include "solve/blas.hpp"
#include "solve/friction_set.hpp"

#include <algorithm>
#include <cmath>

namespace spricka::solve {

using base::at;
using base::index;

namespace {

constexpr int most_rounds = 6;    // of sweeps and Newton steps
constexpr int first_sweeps = 20;  // doubled from round to round
constexpr int most_steps = 25;    // of Newton's method in a round
constexpr int few_steps = 12;     // of it from forces expected: as many as from sweeps
constexpr int local_steps = 20;   // at one contact point
constexpr double arrived = 1e-12; // a residual that no step makes smaller

using NeglectedShearK = Eigen::Vector2d; // zero where there is no second tangent

// The tangential entries of a contact point.
NeglectedShearK tangential(const RoundConeFrictionProblem::RoundFrictionUnit& u,
                           const base::Vector& v) {
  NeglectedShearK t = NeglectedShearK::Zero();
  for (int k = 0; k < u.tangents; ++k) {
    t[k] = v[u.tangent[at(k)]];
  }
  return t;
}

// The nearest place on a disk about the origin.
NeglectedShearK on_disk(const NeglectedShearK& z, double radius) {
  const double size = z.norm();
  return size <= radius ? z : NeglectedShearK(radius / size * z);
}

class RoundSolver {
public:
  explicit RoundSolver(const RoundConeFrictionProblem& problem) : p_(problem) {}

  RoundFrictionState solve(const RoundFrictionStart& start) {
    int steps = 0;
    if (start.expected.size() > 0) {
      approach({.lambda = start.expected, .alpha = start.expected_alpha}, few_steps, 0.0);
      steps = s_.newton_steps;
      if (s_.residual < near_enough) {
        return s_;
      }
    }
    s_.lambda = base::Vector::Zero(p_.rows());
    s_.alpha = start.alpha;
    find_gaps();
    return solve_anew(steps);
  }

  RoundFrictionState approach(const PredictedContactForces& near, int most, double enough) {
    s_.lambda = near.lambda;
    s_.alpha = near.alpha;
    find_gaps();
    s_.newton_steps = newton(most, enough);
    return s_;
  }

private:
  RoundFrictionState solve_anew(int steps) {
    RoundFrictionState swept = s_;
    int sweeps = first_sweeps;
    int all_sweeps = 0;
    RoundFrictionState best = s_;
    best.residual = INFINITY;
    double share = 1.0;
    for (int round = 0; round < most_rounds; ++round, sweeps *= 2, share /= 2.0) {
      s_ = swept;
      for (int k = 0; k < sweeps; ++k) {
        sweep(share);
      }
      all_sweeps += sweeps;
      find_gaps();
      swept = s_;
      steps += newton(most_steps, 0.0);
      if (s_.residual < best.residual) {
        best = s_;
      }
      // A touch as light as round-off may keep it from coming nearer, however often it begins.
      if (best.residual < (round == 0 ? near_enough : accepted_residual)) {
        break;
      }
    }
    best.newton_steps = steps;
    best.sweeps = all_sweeps;
    return best;
  }

  // Gaps from forces and motions, states from both (solve.35), and how far they are off.
  void find_gaps() {
    s_.gap = p_.b + p_.B * s_.alpha;
    blas::gemm(
        {.m = static_cast<int>(p_.rows()), .n = 1, .k = static_cast<int>(p_.rows()), .beta = 1.0},
        {p_.W.data(), static_cast<int>(p_.rows())}, {s_.lambda.data(), static_cast<int>(p_.rows())},
        {s_.gap.data(), static_cast<int>(p_.rows())});
    double scale = p_.force_floor;
    for (const RoundConeFrictionProblem::RoundFrictionUnit& u : p_.units) {
      scale = std::max({scale, s_.lambda[u.normal], 1e-3 * std::abs(p_.b[u.normal])});
    }
    for (const int i : p_.fixed) {
      scale = std::max(scale, std::abs(s_.lambda[i]));
    }
    double worst = 0.0;
    s_.touch.clear();
    for (const RoundConeFrictionProblem::RoundFrictionUnit& u : p_.units) {
      const double pressed = s_.lambda[u.normal] - s_.gap[u.normal];
      const double limit = u.mu * std::max(pressed, 0.0);
      const NeglectedShearK q = tangential(u, s_.lambda);
      const NeglectedShearK z = q - tangential(u, s_.gap);
      worst = std::max(worst, std::abs(s_.lambda[u.normal] - std::max(pressed, 0.0)));
      worst = std::max(worst, (q - on_disk(z, limit)).norm());
      s_.touch.push_back(pressed <= 0.0      ? SlipState::open
                         : z.norm() <= limit ? SlipState::stick
                                             : SlipState::forward);
    }
    for (const int i : p_.fixed) {
      worst = std::max(worst, std::abs(s_.gap[i]));
    }
    const base::Vector left = p_.h + p_.B.transpose() * s_.lambda;
    if (left.size() > 0) {
      worst = std::max(worst, left.cwiseAbs().maxCoeff());
    }
    s_.residual = std::isfinite(worst) ? divide_by_scale(worst, scale) : INFINITY;
  }

  // One contact point after the other, each with its own rows alone; loads on modes that the forces
  // leave over push the bodies on (augmented Lagrangian), as far as `share` says: with all of it a
  // body may rock to and fro for ever.
  void sweep(double share) {
    base::Vector left = p_.h + p_.B.transpose() * s_.lambda;
    const auto gap_of = [&](int i) {
      return p_.b[i] + p_.W.col(i).dot(s_.lambda) + p_.B.row(i).dot(s_.alpha + left);
    };
    const auto move = [&](int i, double force) {
      left += (force - s_.lambda[i]) * p_.B.row(i).transpose();
      s_.lambda[i] = force;
    };
    for (const int i : p_.fixed) {
      move(i, s_.lambda[i] - gap_of(i) / stiffness(i, i));
    }
    for (const RoundConeFrictionProblem::RoundFrictionUnit& u : p_.units) {
      const std::array<int, 3> row{u.normal, u.tangent[0], u.tangent[1]};
      const int count = 1 + u.tangents;
      Eigen::Matrix3d D = Eigen::Matrix3d::Zero();
      Eigen::Vector3d g = Eigen::Vector3d::Zero();
      Eigen::Vector3d f = Eigen::Vector3d::Zero();
      for (int i = 0; i < count; ++i) {
        g[i] = gap_of(row[at(i)]);
        f[i] = s_.lambda[row[at(i)]];
        for (int k = 0; k < count; ++k) {
          D(i, k) = stiffness(row[at(i)], row[at(k)]);
        }
      }
      const Eigen::Vector3d before = f;
      const double step = 1.0 / D.trace();
      for (int k = 0; k < local_steps; ++k) {
        const Eigen::Vector3d now = g + D * (f - before);
        f[0] = std::max(0.0, f[0] - step * now[0]);
        f.tail<2>() = on_disk(f.tail<2>() - step * now.tail<2>(), u.mu * f[0]);
      }
      for (int i = 0; i < count; ++i) {
        move(row[at(i)], f[i]);
      }
    }
    s_.alpha += share * left;
  }

  [[nodiscard]] double stiffness(int i, int k) const {
    return p_.W(i, k) + p_.B.row(i).dot(p_.B.row(k));
  }

  int newton(int most, double enough) {
    RoundFrictionState best = s_;
    int steps = 0;
    for (; steps < most && s_.residual > enough; ++steps) {
      if (!newton_step()) {
        break;
      }
      find_gaps();
      const bool smaller = s_.residual < 0.5 * best.residual;
      best = s_.residual < best.residual ? s_ : best;
      if (best.residual < arrived && !smaller) {
        break; // round-off
      }
    }
    s_ = best;
    return steps;
  }

  // A few rows and a weight for each.
  struct Mix {
    std::array<int, 3> row{};
    std::array<double, 3> weight{};
    int count = 0;
    void add(int i, double share) {
      row[at(count)] = i;
      weight[at(count++)] = share;
    }
  };
  // An unknown force of points in contact and the equation that goes with it:
  // gap . (W lambda + B alpha + b) + own x = right.
  struct Unknown {
    Mix force; ///< what a unit of it is on the rows
    Mix gap;
    double own = 0.0;
    double right = 0.0;
  };

  // g = 0 of a row with its own force, and `follows` that come along with it.
  void add_closed(int i, const Mix& follows, std::vector<Unknown>& list) const {
    Unknown& x = list.emplace_back();
    x.force.add(i, 1.0);
    for (int k = 0; k < follows.count; ++k) {
      x.force.add(follows.row[at(k)], follows.weight[at(k)]);
    }
    x.gap.add(i, 1.0);
    x.own = row_spring;
    x.right = row_spring * s_.lambda[i];
  }

  // Where a point slips: (I - rho P) q - mu z p + rho P v = 0 with the unit vector z against the
  // slip and P = I - z z^T across it (solve.35). Along z that is q . z = mu p, which leaves the
  // pressure and what is across.
  void add_slip(const RoundConeFrictionProblem::RoundFrictionUnit& u,
                std::vector<Unknown>& list) const {
    const NeglectedShearK z = tangential(u, s_.lambda) - tangential(u, s_.gap);
    const NeglectedShearK along = z.normalized();
    Mix follows;
    for (int t = 0; t < u.tangents; ++t) {
      follows.add(u.tangent[at(t)], u.mu * along[t]);
    }
    add_closed(u.normal, follows, list);
    if (u.tangents == 2) {
      const double rho = std::min(1.0, u.mu * std::max(s_.lambda[u.normal], 0.0) / z.norm());
      const NeglectedShearK across(-along[1], along[0]);
      Unknown& x = list.emplace_back();
      for (int t = 0; t < 2; ++t) {
        x.force.add(u.tangent[at(t)], across[t]);
        x.gap.add(u.tangent[at(t)], rho * across[t]);
      }
      x.own = 1.0 - rho;
    }
  }

  [[nodiscard]] std::vector<Unknown> unknowns() const {
    std::vector<Unknown> list;
    for (const int i : p_.fixed) {
      add_closed(i, {}, list);
    }
    for (std::size_t k = 0; k < p_.units.size(); ++k) {
      const RoundConeFrictionProblem::RoundFrictionUnit& u = p_.units[k];
      if (s_.touch[k] == SlipState::forward) {
        add_slip(u, list);
      } else if (s_.touch[k] != SlipState::open) {
        add_closed(u.normal, {}, list);
        for (int t = 0; t < u.tangents; ++t) {
          add_closed(u.tangent[at(t)], {}, list);
        }
      }
    }
    return list;
  }

  // Equations of the forces, columns one by one as W has them, and the balance of the modes.
  // Springs hold what no row holds where it is; the step leaves out of the answer what they take.
  void equations(const std::vector<Unknown>& list, base::Matrix& K, base::Matrix& x) const {
    const auto n = index(list.size());
    const Eigen::Index m = p_.mode_count();
    K.resize(n + m, n + m);
    x.resize(n + m, 1);
    base::Vector opened(p_.rows());
    for (Eigen::Index c = 0; c < n; ++c) {
      const Unknown& own = list[at(c)];
      const Mix& force = own.force;
      opened = force.weight[0] * p_.W.col(force.row[0]);
      base::Vector balance = force.weight[0] * p_.B.row(force.row[0]).transpose();
      for (int k = 1; k < force.count; ++k) {
        opened += force.weight[at(k)] * p_.W.col(force.row[at(k)]);
        balance += force.weight[at(k)] * p_.B.row(force.row[at(k)]).transpose();
      }
      for (Eigen::Index r = 0; r < n; ++r) {
        const Mix& gap = list[at(r)].gap;
        K(r, c) = gap.weight[0] * opened[gap.row[0]];
        if (gap.count > 1) {
          K(r, c) += gap.weight[1] * opened[gap.row[1]];
        }
      }
      K(c, c) += own.own;
      K.col(c).tail(m) = balance;
      x(c, 0) = own.right;
      K.row(c).tail(m).setZero();
      for (int k = 0; k < own.gap.count; ++k) {
        K.row(c).tail(m) += own.gap.weight[at(k)] * p_.B.row(own.gap.row[at(k)]);
        x(c, 0) -= own.gap.weight[at(k)] * p_.b[own.gap.row[at(k)]];
      }
    }
    K.bottomRightCorner(m, m) = -mode_spring * base::Matrix::Identity(m, m);
    x.col(0).tail(m) = -p_.h - mode_spring * s_.alpha;
  }

  bool newton_step() {
    const std::vector<Unknown> list = unknowns();
    const Eigen::Index m = p_.mode_count();
    equations(list, K_, x_);
    const auto size = static_cast<int>(K_.rows());
    std::vector<int> order;
    if (size == 0 || !blas::factorise_lu(size, {K_.data(), size}, order)) {
      return false;
    }
    blas::solve_lu(size, 1, {K_.data(), size}, order, {x_.data(), size});
    if (!x_.allFinite()) {
      return false;
    }
    s_.lambda.setZero();
    for (std::size_t c = 0; c < list.size(); ++c) {
      const Mix& force = list[c].force;
      for (int k = 0; k < force.count; ++k) {
        s_.lambda[force.row[at(k)]] += force.weight[at(k)] * x_(index(c), 0);
      }
    }
    s_.alpha = x_.col(0).tail(m);
    return true;
  }

  const RoundConeFrictionProblem& p_;
  RoundFrictionState s_;
  base::Matrix K_; ///< kept from step to step for its memory
  base::Matrix x_;
};

} // namespace

RoundConeFrictionProblem scale_round_friction_problem(const ControllableProblem& held,
                                                      const std::vector<FrictionRow>& friction,
                                                      double load_scale) {
  RoundConeFrictionProblem p;
  const auto n = index(static_cast<std::size_t>(held.rows()));
  const double root = std::sqrt(held.tau);
  p.inverse = base::Vector::Zero(n);
  std::vector<const FrictionRow*> rubs(static_cast<std::size_t>(n), nullptr);
  std::vector<bool> slips(static_cast<std::size_t>(n), false);
  for (Eigen::Index i = 0; i < n; ++i) {
    p.inverse[i] = held.d[i] > 0.0 ? 1.0 / held.d[i] : 0.0;
  }
  for (const FrictionRow& f : friction) {
    rubs[at(f.normal)] = &f;
    for (const int t : {f.tangent, f.second}) {
      if (t >= 0) {
        slips[at(t)] = true;
        p.inverse[t] = p.inverse[f.normal];
      }
    }
  }
  p.W = p.inverse.asDiagonal() * held.W * p.inverse.asDiagonal();
  p.B = p.inverse.asDiagonal() * held.B * root;
  p.b = p.inverse.asDiagonal() * held.b;
  p.h = held.h * root;
  p.force_floor = p.h.size() > 0 ? std::max(p.h.cwiseAbs().maxCoeff(), load_scale * root) : 0.0;
  for (int i = 0; i < held.rows(); ++i) {
    if (!(held.d[i] > 0.0) || slips[at(i)]) {
      continue;
    }
    if (held.equality[at(i)]) {
      p.fixed.push_back(i);
      continue;
    }
    RoundConeFrictionProblem::RoundFrictionUnit unit{
        .normal = i, .tangents = 0, .tangent = {}, .mu = 0.0};
    if (const FrictionRow* f = rubs[at(i)]) {
      unit.mu = f->mu;
      for (const int t : {f->tangent, f->second}) {
        if (t >= 0) {
          unit.tangent[at(unit.tangents++)] = t;
        }
      }
    }
    p.units.push_back(unit);
  }
  return p;
}

RoundFrictionState solve_round_friction(const RoundConeFrictionProblem& problem,
                                        const RoundFrictionStart& start) {
  return RoundSolver(problem).solve(start);
}

RoundFrictionState iterate_round_friction_newton(const RoundConeFrictionProblem& problem,
                                                 const PredictedContactForces& near, int most,
                                                 double enough) {
  return RoundSolver(problem).approach(near, most, enough);
}

} // namespace spricka::solve
