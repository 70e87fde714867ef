// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/steps/round_gaps.hpp"

#include "contact/recovery.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

#include <fmt/format.h>

namespace spricka::analysis {

namespace {

constexpr double worst_change = 0.05; // of the largest pressure of the pair

// What the increment asks for without friction, with gaps as drawn.
contact::ContactSystem::IncrementProblem
without_friction(const Discretisation& scene, const contact::ContactSystem::IncrementProblem& of) {
  contact::ContactSystem::IncrementProblem d;
  std::vector<double> gap;
  for (std::size_t i = 0; i < of.rows.size(); ++i) {
    const bool rubs = scene.contacts[scene.table.contact_index(of.rows[i])].mu > 0.0;
    // Tangent rows of bonded pairs stay: they are no friction.
    if (rubs && scene.contact_row(of.rows[i]).tangential) {
      continue;
    }
    d.rows.push_back(of.rows[i]);
    d.equality.push_back(of.equality[i]);
    gap.push_back(of.gap[static_cast<Eigen::Index>(i)]);
  }
  d.gap = Eigen::Map<const base::Vector>(gap.data(), static_cast<Eigen::Index>(gap.size()));
  d.load = of.load;
  d.motion = of.motion;
  d.load_scale = of.load_scale;
  return d;
}

// Pressures of one contact as the results show them, from an answer to a problem without friction.
contact::PairPressure pressures(const Discretisation& scene,
                                const contact::ContactSystem::IncrementProblem& d,
                                const solve::ContactSolution& s, std::size_t contact) {
  const contact::PairConstraints& pair = scene.pairs[contact];
  const auto normals = static_cast<Eigen::Index>(pair.normal.size());
  const auto all = normals + static_cast<Eigen::Index>(pair.tangent.size());
  base::Vector lambda = base::Vector::Zero(all);
  base::Vector gap = base::Vector::Zero(normals);
  std::vector<bool> closed(pair.normal.size(), false);
  for (std::size_t i = 0; i < d.rows.size(); ++i) {
    if (scene.table.contact_index(d.rows[i]) == contact) {
      const std::size_t local = d.rows[i] - scene.table.first[contact];
      const auto k = static_cast<Eigen::Index>(i);
      lambda[static_cast<Eigen::Index>(local)] = s.lambda[k];
      if (local < pair.normal.size()) {
        gap[static_cast<Eigen::Index>(local)] = s.gap[k];
        closed[local] = s.closed[i];
      }
    }
  }
  return contact::recover_pressure(pair, lambda, gap, closed,
                                   scene.contacts[contact].type == model::ContactType::bonded);
}

// Largest difference of pressures over the largest pressure.
double change(const contact::PairPressure& a, const contact::PairPressure& b) {
  double largest = 0.0;
  double most = 0.0;
  for (std::size_t n = 0; n < a.nodes.size(); ++n) {
    const double p = a.nodes[n].p_lumped;
    const double q = b.nodes[n].p_lumped;
    largest = std::max({largest, std::abs(p), std::abs(q)});
    most = std::max(most, std::abs(p - q));
  }
  return largest > 0.0 ? most / largest : 0.0;
}

// By how much the gap of a contact differs where it does most [length].
double depth(const contact::PairConstraints& pair) {
  double most = 0.0;
  for (const contact::ConstraintRow& row : pair.normal) {
    most = std::max(most, std::abs(row.round_gap - row.gap) / row.area);
  }
  return most;
}

} // namespace

void warn_of_facet_gaps(const Discretisation& scene, const contact::ContactSystem& system,
                        const contact::ContactSystem::IncrementProblem& problem,
                        const contact::ContactSystem::IncrementSolution& solution,
                        std::vector<results::Note>& notes) {
  const contact::ContactSystem::IncrementProblem drawn = without_friction(scene, problem);
  contact::ContactSystem::IncrementProblem round = drawn;
  std::vector<bool> differs(scene.contacts.size(), false);
  for (std::size_t i = 0; i < round.rows.size(); ++i) {
    const contact::ConstraintRow& row = scene.contact_row(round.rows[i]);
    // A measured gap has no factor of FIT: the difference counts as it is.
    round.gap[static_cast<Eigen::Index>(i)] += row.round_gap - row.gap;
    if (row.round_gap != row.gap) {
      differs[scene.table.contact_index(round.rows[i])] = true;
    }
  }
  if (std::ranges::none_of(differs, std::identity())) {
    return;
  }
  // where only friction holds a body there is nothing to compare
  const solve::ContactSolution smooth =
      problem.friction.empty() ? solution.contact : system.solve_rows(drawn, {}).contact;
  const solve::ContactSolution other = system.solve_rows(round, {}).contact;
  if (smooth.status != solve::ContactStatus::solved ||
      other.status != solve::ContactStatus::solved) {
    return;
  }
  for (std::size_t c = 0; c < scene.contacts.size(); ++c) {
    if (!differs[c]) {
      continue;
    }
    const double most =
        change(pressures(scene, drawn, smooth, c), pressures(scene, round, other, c));
    if (most > worst_change) {
      notes.push_back(results::less_exact_note(fmt::format(
          "contact {}: its gap is measured between element edges, which leave the circles "
          "through their nodes by {:.2g}: between those circles pressures differ by up to {:.2g} % "
          "of the largest; declare GAP, INTERFERENCE or DIAMETRAL, or use more or curved elements",
          scene.contacts[c].name, depth(scene.pairs[c]), 100.0 * most)));
    }
  }
}

} // namespace spricka::analysis
