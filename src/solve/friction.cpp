// SPDX-License-Identifier: GPL-3.0-or-later
#include "solve/friction.hpp"
#include "base/dense_solve.hpp"
#include "base/index.hpp"
#include "solve/blas.hpp"
#include "solve/contact_qp.hpp"
#include "solve/friction_cones.hpp"
#include "solve/friction_proximal_points.hpp"
#include "solve/friction_rest.hpp"
#include "solve/friction_search.hpp"
#include "solve/held_problem.hpp"
#include "solve/load_balance.hpp"
#include "solve/mode_split.hpp"
#include "solve/round_friction.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

namespace spricka::solve {

using base::at;
using base::index;

namespace {

constexpr double at_rest = 1e-10; ///< of the gap scale: no slip
constexpr int anchorings = 12;    ///< of bodies that nothing holds, before they slide

/// Rigid motions that no row in contact hinders.
int loose_motions(const ScaledFrictionProblem& problem, const std::vector<SlipState>& touch) {
  std::vector<int> rows = problem.fixed;
  for (const ScaledFrictionProblem::FrictionUnit& u : problem.units) {
    const SlipState state = touch[at(u.normal)];
    if (state != SlipState::open) {
      rows.push_back(u.normal);
      if (u.tangent >= 0 && state == SlipState::stick) {
        rows.push_back(u.tangent);
      }
    }
  }
  if (rows.empty() || problem.mode_count() == 0) {
    return problem.mode_count();
  }
  base::Matrix B(index(rows.size()), problem.mode_count());
  for (std::size_t r = 0; r < rows.size(); ++r) {
    B.row(index(r)) = problem.B.row(rows[r]);
  }
  return problem.mode_count() - static_cast<int>(base::column_rank(B, 1e-9));
}

/// Back from scaled units, with every condition kept to the last bit that forces have.
void take_solution(const ScaledFrictionProblem& scaled, const ControllableProblem& held,
                   const ModeSplit& split, const FrictionSearchResult& search,
                   FrictionSolution& answer) {
  ContactSolution& c = answer.contact;
  const SlipStateSolution& s = search.solution;
  c.residual = friction_residual(scaled, s, search.touch);
  answer.touch = search.touch;
  base::Vector lambda = s.lambda;
  base::Vector gap = s.gap;
  const auto close = [&](int i, bool closed) {
    c.closed[at(i)] = closed;
    lambda(i) = closed ? lambda(i) : 0.0;
  };
  for (const int i : scaled.fixed) {
    close(i, true);
  }
  for (const ScaledFrictionProblem::FrictionUnit& u : scaled.units) {
    const SlipState state = search.touch[at(u.normal)];
    const bool closed = state != SlipState::open;
    close(u.normal, closed);
    lambda(u.normal) = std::max(lambda(u.normal), 0.0);
    gap(u.normal) = closed ? 0.0 : std::max(gap(u.normal), 0.0);
    if (u.tangent >= 0) {
      close(u.tangent, closed);
      // Round-off of the solution must not leave a force outside its cone.
      const double limit = u.mu * lambda(u.normal);
      lambda(u.tangent) = std::clamp(lambda(u.tangent), -limit, limit);
      if (closed && std::abs(gap(u.tangent)) <= at_rest * s.gap_scale(u.tangent)) {
        answer.touch[at(u.normal)] = SlipState::stick; // at the limit, but it does not move
        answer.touch[at(u.tangent)] = SlipState::stick;
      }
      gap(u.tangent) = answer.touch[at(u.tangent)] == SlipState::stick ? 0.0 : gap(u.tangent);
    }
  }
  for (int i = 0; i < held.rows(); ++i) {
    if (held.d(i) > 0.0) {
      c.lambda(i) = lambda(i) / held.d(i);
      c.gap(i) = gap(i) * held.d(i);
    }
  }
  const base::Vector alpha = split.controllable * (s.alpha * std::sqrt(held.tau));
  c.alpha = alpha - split.uncontrollable * (split.uncontrollable.transpose() * alpha);
  c.resting_modes += loose_motions(scaled, search.touch);
}

/// Rows without compliance and modes must keep their conditions by themselves.
bool dead_rows_hold(const ControllableProblem& held, const std::vector<FrictionRow>& friction) {
  std::vector<bool> slips(std::size_t(held.rows()), false);
  for (const FrictionRow& f : friction) {
    slips[at(f.tangent)] = true;
    if (f.second >= 0) {
      slips[at(f.second)] = true;
    }
  }
  const double size = held.rows() > 0 ? held.b.cwiseAbs().maxCoeff() : 0.0;
  for (int i = 0; i < held.rows(); ++i) {
    const bool wrong = held.equality[at(i)] ? std::abs(held.b(i)) > accepted_residual * size
                                            : held.b(i) < -accepted_residual * size;
    if (!(held.d(i) > 0.0) && !slips[at(i)] && wrong) {
      return false;
    }
  }
  return true;
}

/// Where bodies stay that nothing holds, in scaled modes.
base::Vector anchor_at(const base::Vector& alpha, const ControllableProblem& held,
                       const ModeSplit& split) {
  if (alpha.size() == 0 || held.mode_count() == 0) {
    return base::Vector::Zero(held.mode_count());
  }
  // Modes that no row feels have no place among the scaled ones: least squares drops their part.
  const base::Vector a = base::least_squares(split.controllable, alpha);
  return a / std::sqrt(held.tau);
}

/// The increment with slips that are vectors: round cones.
void solve_round_cones(const FrictionProblem& problem, const ControllableProblem& held,
                       const ModeSplit& split, double least, FrictionSolution& answer) {
  const RoundConeFrictionProblem scaled =
      scale_round_friction_problem(held, problem.friction, problem.contact.load_scale);
  RoundFrictionStart start{.alpha = anchor_at(problem.alpha_start, held, split)};
  if (problem.expected.lambda.size() == held.rows()) {
    start.expected = (scaled.inverse.array() > 0.0)
                         .select(problem.expected.lambda.array() / scaled.inverse.array(), 0.0);
    start.expected_alpha = anchor_at(problem.expected.alpha, held, split);
  }
  RoundFrictionState found = solve_round_friction(scaled, start);
  if (!(found.residual < accepted_residual)) {
    found = solve_by_proximal_points(scaled, start.alpha, found);
  }
  ContactSolution& c = answer.contact;
  c.block_iterations = found.newton_steps;
  c.pivots = found.sweeps;
  c.residual = found.residual;
  if (!(found.residual < accepted_residual)) {
    c.status = ContactStatus::max_iterations;
    return;
  }
  c.resting_modes += move_unheld_bodies_to_anchor(held, split, scaled, start.alpha, least, found);
  base::Vector lambda = found.lambda;
  base::Vector gap = found.gap;
  const double least_slip = at_rest * found.gap.cwiseAbs().maxCoeff();
  for (const int i : scaled.fixed) {
    c.closed[at(i)] = true;
  }
  for (std::size_t k = 0; k < scaled.units.size(); ++k) {
    const RoundConeFrictionProblem::RoundFrictionUnit& u = scaled.units[k];
    const bool closed = found.touch[k] != SlipState::open;
    // Every condition to the last bit that forces have.
    lambda[u.normal] = closed ? std::max(lambda[u.normal], 0.0) : 0.0;
    gap[u.normal] = closed ? 0.0 : std::max(gap[u.normal], 0.0);
    double shear = 0.0;
    double slip = 0.0;
    for (int t = 0; t < u.tangents; ++t) {
      shear = std::hypot(shear, lambda[u.tangent[at(t)]]);
      slip = std::hypot(slip, gap[u.tangent[at(t)]]);
    }
    const double limit = u.mu * lambda[u.normal];
    const bool rests = closed && (found.touch[k] == SlipState::stick || slip <= least_slip);
    const SlipState touch = !closed ? SlipState::open
                            : rests ? SlipState::stick
                                    : SlipState::forward;
    c.closed[at(u.normal)] = closed;
    answer.touch[at(u.normal)] = u.tangents > 0 || !closed ? touch : SlipState::stick;
    for (int t = 0; t < u.tangents; ++t) {
      const int row = u.tangent[at(t)];
      c.closed[at(row)] = closed;
      answer.touch[at(row)] = touch;
      lambda[row] = closed && shear > limit ? lambda[row] * (limit / shear) : lambda[row];
      lambda[row] = closed ? lambda[row] : 0.0;
      gap[row] = rests ? 0.0 : gap[row];
    }
  }
  for (Eigen::Index i = 0; i < lambda.size(); ++i) {
    if (scaled.inverse[i] > 0.0) {
      c.lambda[i] = lambda[i] * scaled.inverse[i];
      c.gap[i] = gap[i] / scaled.inverse[i];
    }
  }
  const base::Vector alpha = split.controllable * (found.alpha * std::sqrt(held.tau));
  c.alpha = alpha - split.uncontrollable * (split.uncontrollable.transpose() * alpha);
  c.status = ContactStatus::solved;
}

/// Where no solution was found: a load that round cones do not hold, though those of sixteen sides
/// about them would, is named.
void name_what_slides(const FrictionProblem& problem, const ControllableProblem& held,
                      const ModeSplit& split, double least, FrictionSolution& answer) {
  const LoadBalance balance = balance_round_cones(held, problem.friction);
  if (unstopped_opening_motion(split, balance, least).size() > 0) {
    answer.contact.status = ContactStatus::unheld_mode;
    answer.contact.unheld = sliding_motion(split, held, problem.friction, balance);
    answer.slides = true;
  }
}

/// The same increment without friction, and the states and motions that it ends in: where bodies
/// come to lie against each other only in this increment no better beginning is at hand.
struct SmoothStart {
  std::vector<SlipState> touch; ///< [n]; empty: there is none
  base::Vector alpha;
};

SmoothStart smooth_start(const FrictionProblem& problem, const ContactSettings& settings) {
  const ContactProblem& whole = problem.contact;
  std::vector<bool> slips(whole.equality.size(), false);
  for (const FrictionRow& f : problem.friction) {
    slips[at(f.tangent)] = true;
  }
  std::vector<int> rows;
  for (std::size_t i = 0; i < slips.size(); ++i) {
    if (!slips[i]) {
      rows.push_back(static_cast<int>(i));
    }
  }
  ContactProblem plain = whole;
  // Tangents that slip freely have no force: they are left out, and their slip is read off
  // afterwards.
  plain.W = whole.W(rows, rows);
  plain.B = whole.B(rows, Eigen::all);
  plain.b = whole.b(rows);
  plain.equality.clear();
  for (const int i : rows) {
    plain.equality.push_back(whole.equality[at(i)]);
  }
  const ContactSolution found = solve_contact(plain, settings, {});
  if (found.status != ContactStatus::solved) {
    return {};
  }
  SmoothStart start{std::vector<SlipState>(slips.size(), SlipState::open), found.alpha};
  base::Vector lambda = base::Vector::Zero(whole.b.size());
  for (std::size_t k = 0; k < rows.size(); ++k) {
    start.touch[at(rows[k])] = found.closed[k] ? SlipState::stick : SlipState::open;
    lambda(rows[k]) = found.lambda(index(k));
  }
  const base::Vector moved = whole.b + whole.W * lambda + whole.B * found.alpha;
  for (const FrictionRow& f : problem.friction) {
    if (start.touch[at(f.normal)] != SlipState::open) {
      // Each closed row slips the way that it would go without friction.
      start.touch[at(f.tangent)] =
          moved(f.tangent) > 0.0 ? SlipState::forward : SlipState::backward;
      start.touch[at(f.normal)] = start.touch[at(f.tangent)];
    }
  }
  return start;
}

/// Solves with bodies anchored where they are until they are held, rest or slide away.
void walk_to_rest(const ScaledFrictionProblem& scaled, const ControllableProblem& held,
                  const ModeSplit& split, std::pair<base::Vector, FrictionSearchResult> state,
                  const ContactSettings& settings, FrictionSolution& answer) {
  ContactSolution& c = answer.contact;
  base::Vector anchor = std::move(state.first);
  FrictionSearchResult search = std::move(state.second);
  base::Vector drive = base::Vector::Zero(scaled.mode_count());
  for (int turn = 0; turn < anchorings; ++turn) {
    search = find_consistent_states(scaled, anchor, search.touch, settings, c);
    if (!search.settled) {
      c.status = ContactStatus::max_iterations;
      return;
    }
    const base::Vector before = drive;
    // What the rows leave of the loads on modes, the force of the springs (solve.24).
    drive = scaled.h + scaled.B.transpose() * search.solution.lambda;
    // Held by rows, or at rest: no spring carries anything that counts.
    if (search.solution.held || drive.norm() <= rest_load * search.solution.force_scale) {
      take_solution(scaled, held, split, search, answer);
      c.status =
          c.residual < accepted_residual ? ContactStatus::solved : ContactStatus::max_iterations;
      return;
    }
    // The anchor has moved on and the spring has to carry the same again: the body slides.
    if (turn > 0 && (drive - before).norm() <= 1e-6 * drive.norm()) {
      c.status = ContactStatus::unheld_mode;
      c.unheld = (split.controllable * drive).normalized();
      answer.slides = true;
      return;
    }
    anchor = search.solution.alpha;
  }
  c.status = ContactStatus::max_iterations;
}

} // namespace

FrictionSolution solve_friction(const FrictionProblem& problem, const ContactSettings& settings,
                                const std::vector<SlipState>& start) {
  blas::force_single_blas_thread();
  const ContactProblem& contact = problem.contact;
  const Eigen::Index n = contact.b.size();
  FrictionSolution answer;
  ContactSolution& c = answer.contact;
  c.lambda = base::Vector::Zero(n);
  c.alpha = base::Vector::Zero(contact.h.size());
  c.gap = contact.b;
  c.closed.assign(static_cast<std::size_t>(n), false);
  answer.touch.assign(static_cast<std::size_t>(n), SlipState::open);
  const double scale = load_scale(contact);

  // 1. modes that no row touches, and loads that no force within the cones can take
  const ModeSplit split = split_controllable_modes(contact.B, contact.opening_scale);
  c.resting_modes = static_cast<int>(split.uncontrollable.cols());
  c.unheld = uncontrollable_motion(split, contact.h, resting_load * scale);
  ControllableProblem held = restrict_to_controllable_modes(contact, split);
  const double least = rest_load * std::max(scale, contact.h.norm());
  if (c.unheld.size() == 0) {
    const LoadBalance balance =
        balance_loads(cone_edge_balance_problem(held.B, held.h, held.equality, problem.friction));
    c.unheld = unstopped_opening_motion(split, balance, least);
    if (c.unheld.size() > 0) {
      answer.slides = true;
      c.unheld = sliding_motion(split, held, problem.friction, balance);
    }
    if (balance.remainder.size() > 0) {
      // What is left below `least` would otherwise drive a motion that no row can stop.
      held.h -= balance.remainder;
    }
  }
  if (c.unheld.size() > 0) {
    c.status = ContactStatus::unheld_mode;
    return answer;
  }
  if (!dead_rows_hold(held, problem.friction)) {
    c.status = ContactStatus::inconsistent;
    return answer;
  }

  // 2. the increment itself
  if (has_round_cones(problem.friction)) {
    solve_round_cones(problem, held, split, least, answer);
    if (c.status == ContactStatus::max_iterations) {
      name_what_slides(problem, held, split, least, answer);
    }
    return answer;
  }
  const ScaledFrictionProblem scaled =
      scale_friction_problem(held, problem.friction, contact.load_scale);
  FrictionSearchResult first;
  first.touch = start;
  first.touch.resize(static_cast<std::size_t>(n), SlipState::stick);
  walk_to_rest(scaled, held, split, {anchor_at(problem.alpha_start, held, split), std::move(first)},
               settings, answer);
  if (c.status != ContactStatus::max_iterations) {
    return answer;
  }

  // 3. once more from where the bodies would lie without friction
  SmoothStart smooth = smooth_start(problem, settings);
  for (const bool sticks : {false, true}) {
    if (smooth.touch.empty() || c.status != ContactStatus::max_iterations) {
      break;
    }
    if (sticks) {
      // The second try: the same rows closed, but all of them sticking.
      std::ranges::replace_if(
          smooth.touch, [](SlipState touch) { return touch != SlipState::open; }, SlipState::stick);
    }
    FrictionSearchResult second;
    second.touch = smooth.touch;
    walk_to_rest(scaled, held, split, {anchor_at(smooth.alpha, held, split), std::move(second)},
                 settings, answer);
  }
  return answer;
}

} // namespace spricka::solve
