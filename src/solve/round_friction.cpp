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
constexpr int local_steps = 20;   // at one contact point
constexpr double arrived = 1e-12; // a residual that no step makes smaller
constexpr double near_enough = 1e-9;

using Shear = Eigen::Vector2d; // zero where there is no second tangent

class RoundSolver {
public:
  RoundSolver(const RoundFriction& problem, const base::Vector& alpha) : p_(problem) {
    s_.lambda = base::Vector::Zero(p_.rows());
    s_.alpha = alpha;
    find_gaps();
  }

  RoundState solve() {
    RoundState swept = s_;
    int sweeps = first_sweeps;
    int steps = 0;
    int all_sweeps = 0;
    RoundState best = s_;
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
      steps += newton();
      if (s_.residual < best.residual) {
        best = s_;
      }
      if (best.residual < near_enough) {
        break;
      }
    }
    best.newton_steps = steps;
    best.sweeps = all_sweeps;
    return best;
  }

private:
  [[nodiscard]] Shear tangential(const RoundFriction::Unit& u, const base::Vector& v) const {
    Shear t = Shear::Zero();
    for (int k = 0; k < u.tangents; ++k) {
      t[k] = v[u.tangent[at(k)]];
    }
    return t;
  }

  static Shear on_disk(const Shear& z, double radius) {
    const double size = z.norm();
    return size <= radius ? z : Shear(radius / size * z);
  }

  // Gaps from forces and motions, states from both (solve.35), and how far they are off.
  void find_gaps() {
    s_.gap = p_.b + p_.B * s_.alpha;
    blas::gemm(
        {.m = static_cast<int>(p_.rows()), .n = 1, .k = static_cast<int>(p_.rows()), .beta = 1.0},
        {p_.W.data(), static_cast<int>(p_.rows())}, {s_.lambda.data(), static_cast<int>(p_.rows())},
        {s_.gap.data(), static_cast<int>(p_.rows())});
    double scale = p_.force_floor;
    for (const RoundFriction::Unit& u : p_.units) {
      scale = std::max({scale, s_.lambda[u.normal], 1e-3 * std::abs(p_.b[u.normal])});
    }
    for (const int i : p_.fixed) {
      scale = std::max(scale, std::abs(s_.lambda[i]));
    }
    double worst = 0.0;
    s_.touch.clear();
    for (const RoundFriction::Unit& u : p_.units) {
      const double pressed = s_.lambda[u.normal] - s_.gap[u.normal];
      const double limit = u.mu * std::max(pressed, 0.0);
      const Shear q = tangential(u, s_.lambda);
      const Shear z = q - tangential(u, s_.gap);
      worst = std::max(worst, std::abs(s_.lambda[u.normal] - std::max(pressed, 0.0)));
      worst = std::max(worst, (q - on_disk(z, limit)).norm());
      s_.touch.push_back(pressed <= 0.0      ? Touch::open
                         : z.norm() <= limit ? Touch::stick
                                             : Touch::forward);
    }
    for (const int i : p_.fixed) {
      worst = std::max(worst, std::abs(s_.gap[i]));
    }
    const base::Vector left = p_.h + p_.B.transpose() * s_.lambda;
    if (left.size() > 0) {
      worst = std::max(worst, left.cwiseAbs().maxCoeff());
    }
    s_.residual = std::isfinite(worst) ? relative(worst, scale) : INFINITY;
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
    for (const RoundFriction::Unit& u : p_.units) {
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

  int newton() {
    RoundState best = s_;
    int steps = 0;
    for (; steps < most_steps && s_.residual > 0.0; ++steps) {
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

  // The rows in contact and what each asks for.
  struct Active {
    std::vector<int> row;
    std::vector<int> place; ///< [n] among them, -1: no force
    void add(int i) {
      place[at(i)] = static_cast<int>(row.size());
      row.push_back(i);
    }
  };

  [[nodiscard]] Active active() const {
    Active a;
    a.place.assign(static_cast<std::size_t>(p_.rows()), -1);
    for (const int i : p_.fixed) {
      a.add(i);
    }
    for (std::size_t k = 0; k < p_.units.size(); ++k) {
      const RoundFriction::Unit& u = p_.units[k];
      if (s_.touch[k] != Touch::open) {
        a.add(u.normal);
        for (int t = 0; t < u.tangents; ++t) {
          a.add(u.tangent[at(t)]);
        }
      }
    }
    return a;
  }

  // g = 0 of row i in equation r: W lambda + B alpha = -b, times `share`.
  void add_gap(const Active& a, Eigen::Index r, int i, double share, base::Matrix& K,
               base::Matrix& x) const {
    for (std::size_t c = 0; c < a.row.size(); ++c) {
      K(r, index(c)) += share * p_.W(i, a.row[c]);
    }
    K.row(r).tail(p_.modes()) += share * p_.B.row(i);
    x(r, 0) -= share * p_.b[i];
  }

  // Where a point slips: (I - rho P) q - mu z p + rho P v = 0 with the unit vector z against the
  // slip and P = I - z z^T across it (solve.35).
  void add_slip(const Active& a, const RoundFriction::Unit& u, base::Matrix& K,
                base::Matrix& x) const {
    const Shear z = tangential(u, s_.lambda) - tangential(u, s_.gap);
    const Shear along = z.normalized();
    const double rho =
        u.tangents == 2 ? std::min(1.0, u.mu * std::max(s_.lambda[u.normal], 0.0) / z.norm()) : 0.0;
    const Eigen::Matrix2d across = Eigen::Matrix2d::Identity() - along * along.transpose();
    for (int j = 0; j < u.tangents; ++j) {
      const Eigen::Index r = a.place[at(u.tangent[at(j)])];
      K(r, a.place[at(u.normal)]) -= u.mu * along[j];
      for (int k = 0; k < u.tangents; ++k) {
        const int row = u.tangent[at(k)];
        K(r, a.place[at(row)]) += (j == k ? 1.0 : 0.0) - rho * across(j, k);
        if (rho > 0.0) {
          add_gap(a, r, row, rho * across(j, k), K, x);
        }
      }
    }
  }

  bool newton_step() {
    const Active a = active();
    const auto n = index(a.row.size());
    const Eigen::Index m = p_.modes();
    const auto size = static_cast<int>(n + m);
    base::Matrix K = base::Matrix::Zero(n + m, n + m);
    base::Matrix x = base::Matrix::Zero(n + m, 1);
    const auto closed = [&](int i) {
      const Eigen::Index r = a.place[at(i)];
      add_gap(a, r, i, 1.0, K, x);
      K(r, r) += row_spring;
      x(r, 0) += row_spring * s_.lambda[i];
    };
    for (const int i : p_.fixed) {
      closed(i);
    }
    for (std::size_t k = 0; k < p_.units.size(); ++k) {
      const RoundFriction::Unit& u = p_.units[k];
      if (s_.touch[k] == Touch::open) {
        continue;
      }
      closed(u.normal);
      if (s_.touch[k] == Touch::forward) {
        add_slip(a, u, K, x);
        continue;
      }
      for (int t = 0; t < u.tangents; ++t) {
        closed(u.tangent[at(t)]);
      }
    }
    // Springs hold what no row holds where it is; the step leaves out of the answer what they take.
    for (Eigen::Index c = 0; c < n; ++c) {
      K.col(c).tail(m) = p_.B.row(a.row[at(c)]).transpose();
    }
    K.bottomRightCorner(m, m) = -mode_spring * base::Matrix::Identity(m, m);
    x.col(0).tail(m) = -p_.h - mode_spring * s_.alpha;
    std::vector<int> order;
    if (size == 0 || !blas::lu(size, {K.data(), size}, order)) {
      return false;
    }
    blas::solve_lu(size, 1, {K.data(), size}, order, {x.data(), size});
    if (!x.allFinite()) {
      return false;
    }
    s_.lambda.setZero();
    for (Eigen::Index c = 0; c < n; ++c) {
      s_.lambda[a.row[at(c)]] = x(c, 0);
    }
    s_.alpha = x.col(0).tail(m);
    return true;
  }

  const RoundFriction& p_;
  RoundState s_;
};

} // namespace

RoundFriction round_friction(const HeldProblem& held, const std::vector<FrictionRow>& friction,
                             double load_scale) {
  RoundFriction p;
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
    RoundFriction::Unit unit{.normal = i, .tangents = 0, .tangent = {}, .mu = 0.0};
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

RoundState solve_round(const RoundFriction& problem, const base::Vector& alpha) {
  return RoundSolver(problem, alpha).solve();
}

} // namespace spricka::solve
